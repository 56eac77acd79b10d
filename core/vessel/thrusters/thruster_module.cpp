#include "core/vessel/thrusters/thruster_module.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/error.h"

namespace nilas::vessel {

std::string thrust_channel(const Thruster& thruster) { return thruster.name + ".thrust"; }
std::string angle_channel(const Thruster& thruster) { return thruster.name + ".angle"; }
std::string actual_thrust_channel(const Thruster& thruster) { return thruster.name + ".thrust_actual"; }
std::string actual_angle_channel(const Thruster& thruster) { return thruster.name + ".angle_actual"; }
std::string works_channel(const Thruster& thruster) { return thruster.name + ".works"; }

namespace {

/// Share of its limit from which a thruster is asked for all that it gives.
constexpr double k_at_limit = 0.999;

/// Indices of a thruster's channels; -1 where it does not turn.
struct ThrusterChannels {
  int thrust = -1, angle = -1, actual_thrust = -1, actual_angle = -1, works = -1;
};

class ThrusterModule : public bodies::ForceModule {
 public:
  ThrusterModule(const ThrusterSettings& settings, std::shared_ptr<Channels> channels)
      : settings_(settings),
        channels_(std::move(channels)),
        states_(settings.thrusters.size()),
        now_(settings.start),
        at_limit_(states_.size()) {
    NILAS_DEMAND(settings_.commands.size() == states_.size());
    for (std::size_t k = 0; k < states_.size(); ++k) {
      const Thruster& thruster = settings_.thrusters[k];
      const ThrusterState& command = settings_.commands[k];
      ThrusterChannels added;
      added.thrust = channels_->add(thrust_channel(thruster), "N", command.thrust);
      added.actual_thrust = channels_->add_measured(actual_thrust_channel(thruster), "N", 0);
      added.works = channels_->add_measured(works_channel(thruster), "", thruster.works(settings_.start) ? 1 : 0);
      if (thruster.turns()) {
        added.angle = channels_->add(angle_channel(thruster), "rad", command.angle);
        added.actual_angle = channels_->add_measured(actual_angle_channel(thruster), "rad", command.angle);
        states_[k].angle = command.angle;
      }
      indices_.push_back(added);
    }
  }

  std::string name() const override { return "thruster"; }
  /// They set the vessel in motion, but free ice at no one velocity.
  std::optional<Vec3> drift() const override { return Vec3::Zero(); }

  void add_forces(const bodies::Bodies& bodies, double t, bodies::Wrenches& out) override {
    for (std::size_t k = 0; k < states_.size(); ++k) {
      const PointForce at = force_of(k, bodies, t);
      out[settings_.hull] += {at.force, at.arm.cross(at.force)};
    }
  }
  std::vector<bodies::DrawnLine> drawn(const bodies::Bodies& bodies) const override {
    std::vector<bodies::DrawnLine> lines;
    for (std::size_t k = 0; k < states_.size(); ++k) {
      const PointForce at = force_of(k, bodies, now_);
      bodies::add_arrow(bodies::DrawnLine::Kind::thruster, settings_.thrusters[k].name,
                        bodies.p_GB[settings_.hull] + at.arm, at.force, lines);
    }
    return lines;
  }

  void end_substep(const bodies::Bodies& /*bodies*/, double t, double h) override {
    energy_ += h * power();
    now_ = t;
    time_ += h;
    for (std::size_t k = 0; k < states_.size(); ++k) {
      const Thruster& thruster = settings_.thrusters[k];
      const ThrusterChannels& at = indices_[k];
      if (thruster.works(t) && thruster.saturation((*channels_)[at.thrust]) >= k_at_limit) at_limit_[k] += h;
      const double angle = at.angle < 0 ? 0 : (*channels_)[at.angle];
      states_[k] = advanced(thruster, states_[k], (*channels_)[at.thrust], angle, t - h, h);
      channels_->set(at.actual_thrust, states_[k].thrust);
      channels_->set(at.works, thruster.works(t) ? 1 : 0);
      if (at.actual_angle >= 0) channels_->set(at.actual_angle, states_[k].angle);
    }
  }

  std::vector<std::string> columns() const override {
    std::vector<std::string> names;
    for (const Thruster& thruster : settings_.thrusters) {
      const std::string start = "thruster_" + thruster.name;
      names.push_back(start + "_N");
      if (thruster.turns()) names.push_back(start + "_deg");
      names.push_back(start + "_saturation_1");
    }
    names.emplace_back("thruster_power_W");
    return names;
  }
  void append_values(std::vector<double>& values) const override {
    for (std::size_t k = 0; k < states_.size(); ++k) {
      const Thruster& thruster = settings_.thrusters[k];
      values.push_back(states_[k].thrust);
      if (thruster.turns()) values.push_back(states_[k].angle / k_deg);
      values.push_back(thruster.saturation(states_[k].thrust));
    }
    values.push_back(power());
  }
  std::optional<double> total(std::string_view name) const override {
    return name == k_thruster_energy ? std::optional(energy_) : std::nullopt;
  }
  std::vector<bodies::RunFigure> figures() const override {
    std::vector<bodies::RunFigure> all{{"energy_J", energy_, "thrusters took", fmt::format("{:.4g} J", energy_)}};
    constexpr double k_percent = 100;
    std::string seen;
    for (std::size_t k = 0; k < states_.size(); ++k) {
      const std::string& name = settings_.thrusters[k].name;
      const double share = time_ > 0 ? at_limit_[k] / time_ : 0;
      all.push_back({"at_limit_" + name + "_1", share, "", ""});
      if (share > 0) seen += fmt::format("{}{} {:.3g} %", seen.empty() ? "" : ", ", name, k_percent * share);
    }
    all.push_back({"time_s", time_, "thrusters at limit", seen.empty() ? "none at any time" : seen + " of the time"});
    return all;
  }

  void save(const bodies::Bodies& /*bodies*/, StateWriter out) const override {
    std::vector<double> thrusts, angles;
    for (const ThrusterState& state : states_) {
      thrusts.push_back(state.thrust);
      angles.push_back(state.angle);
    }
    out.add("thrusts", thrusts);
    out.add("angles", angles);
    out.add("energy", energy_);
    out.add("now", now_);
    out.add("time", time_);
    out.add("at_limit", at_limit_);
  }
  void restore(const StateReader& in) override {
    std::vector<double> thrusts, angles;
    in.get("thrusts", thrusts, states_.size());
    in.get("angles", angles, states_.size());
    in.get("energy", energy_);
    in.get("now", now_);
    in.get("time", time_);
    in.get("at_limit", at_limit_, states_.size());
    for (std::size_t k = 0; k < states_.size(); ++k) states_[k] = {thrusts[k], angles[k]};
  }

 private:
  /// A force in G, and the arm from the centre of mass to where it acts.
  struct PointForce {
    Vec3 arm, force;
  };
  PointForce force_of(std::size_t k, const bodies::Bodies& bodies, double t) const {
    const int b = settings_.hull;
    const Mat3& R = bodies.R_GB[b];
    const Thruster& thruster = settings_.thrusters[k];
    const Vec3 arm = R * (thruster.at_V - settings_.com_V), point = bodies.p_GB[b] + arm;
    Vec3 velocity = bodies.velocity_at(b, point);
    if (settings_.water_velocity) velocity -= settings_.water_velocity(point, t);
    const Vec3 through = R.transpose() * velocity;
    const Vec2 in_vessel = thruster_force(thruster, states_[k], through.head<2>());
    return {arm, R * Vec3(in_vessel.x(), in_vessel.y(), 0)};
  }
  double power() const {
    double sum = 0;
    for (std::size_t k = 0; k < states_.size(); ++k) sum += settings_.thrusters[k].power_at(states_[k].thrust);
    return sum;
  }

  ThrusterSettings settings_;
  std::shared_ptr<Channels> channels_;
  std::vector<ThrusterState> states_;
  std::vector<ThrusterChannels> indices_;
  double energy_ = 0;             ///< taken since the start [J]
  double now_ = 0;                ///< end of the last substep, for pictures [s]
  double time_ = 0;               ///< since the start [s]
  std::vector<double> at_limit_;  ///< time in which the command was at the limit [s]
};

}  // namespace

std::unique_ptr<bodies::ForceModule> make_thrusters(const ThrusterSettings& settings,
                                                    const std::shared_ptr<Channels>& channels) {
  return std::make_unique<ThrusterModule>(settings, channels);
}

}  // namespace nilas::vessel
