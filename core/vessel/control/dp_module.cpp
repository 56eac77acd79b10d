#include "core/vessel/control/dp_module.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/error.h"
#include "core/vessel/control/loss_of_station.h"
#include "core/vessel/control/station_statistics.h"
#include "core/vessel/thrusters/actuator.h"
#include "core/vessel/thrusters/thruster_module.h"

namespace nilas::vessel {

Vec3 plane_position(const bodies::Bodies& bodies, int body) {
  const Mat3& R = bodies.R_GB[body];
  return {bodies.p_GB[body].x(), bodies.p_GB[body].y(), std::atan2(R(1, 0), R(0, 0))};
}

Vec3 plane_velocity(const bodies::Bodies& bodies, int body) {
  const Vec3& v = bodies.v_GB[body];
  return plane_rotation(plane_position(bodies, body).z()).transpose() * Vec3(v.x(), v.y(), bodies.w_GB[body].z());
}

namespace {

/// Indices of the channels of a thruster; -1 where it does not turn.
struct DpChannels {
  int thrust, angle, actual_thrust, actual_angle, works;
};

/// Path, watch circle and set-point at time t, at a height.
std::vector<bodies::DrawnLine> drawn_plan(const DpSettings& settings, double t, double height) {
  constexpr int k_sides = 36;
  std::vector<bodies::DrawnLine> lines;
  const auto add = [&](const char* name, const std::vector<Vec2>& points) {
    lines.push_back({bodies::DrawnLine::Kind::path, name, 0, {}});
    for (const Vec2& x : points) lines.back().points.emplace_back(x.x(), x.y(), height);
  };
  const Vec2 target = settings.plan.at(t).position.head<2>();
  if (const std::vector<Vec2> way = settings.plan.way(); way.size() > 1) add("path", way);
  if (settings.watch_circle) {
    std::vector<Vec2> circle;
    for (int k = 0; k <= k_sides; ++k) {
      const double angle = 2 * k_pi * k / k_sides;
      circle.push_back(target + *settings.watch_circle * Vec2(std::cos(angle), std::sin(angle)));
    }
    add("watch circle", circle);
  }
  add("set-point", {target});
  return lines;
}

class Dp : public bodies::Module {
 public:
  Dp(const DpSettings& settings, Allocation allocation, std::shared_ptr<Channels> channels)
      : settings_(settings),
        allocation_(std::move(allocation)),
        channels_(std::move(channels)),
        sensors_(settings.sensors, settings.start, settings.position),
        observer_(settings.observer, settings.position, settings.velocity),
        reference_(settings.filter_bandwidth, settings.position),
        controller_(settings.controller),
        statistics_(settings.window[0], settings.window[1], settings.watch_circle),
        position_(settings.position),
        now_(settings.start) {
    for (const Thruster& thruster : allocation_.thrusters()) {
      indices_.push_back({channels_->find(thrust_channel(thruster)), channels_->find(angle_channel(thruster)),
                          channels_->find(actual_thrust_channel(thruster)),
                          channels_->find(actual_angle_channel(thruster)), channels_->find(works_channel(thruster))});
      const DpChannels& found = indices_.back();
      NILAS_DEMAND(found.thrust >= 0 && found.actual_thrust >= 0 && found.works >= 0);
      NILAS_DEMAND(!thruster.turns() || (found.angle >= 0 && found.actual_angle >= 0));
      most_thrust_ += std::max(thruster.most_ahead, thruster.most_astern);
    }
  }

  std::string name() const override { return "control"; }

  void end_substep(const bodies::Bodies& bodies, double t, double h) override {
    now_ = t;
    follow_truth(plane_position(bodies, settings_.hull));
    sensors_.note(t, position_);
    judge(t);
    impulse_ += h * acting_;
    elapsed_ += h;
    acting_ = allocation_.load_of(measured_thrusts());
    constexpr double k_rounding = 1e-9;  // of a period
    if (const double periods = (t - settings_.start) / settings_.sensors.period + k_rounding;
        periods >= static_cast<double>(due_)) {
      due_ = static_cast<long>(std::floor(periods)) + 1;
      control(bodies, t);
    }
    statistics_.add(station(t), t, h);
  }

  std::vector<std::string> columns() const override {
    return {"dp_offset_m",     "dp_heading_error_deg", "dp_estimate_error_m", "dp_wanted_fx_N", "dp_wanted_fy_N",
            "dp_wanted_mz_Nm", "dp_shortfall_N",       "dp_shortfall_Nm",     "dp_outside_1"};
  }
  void append_values(std::vector<double>& values) const override {
    const double estimate_error = (observer_.position() - position_).head<2>().norm();
    values.insert(values.end(),
                  {last_.offset, last_.heading_error / k_deg, estimate_error, wanted_.x(), wanted_.y(), wanted_.z(),
                   shortfall_.head<2>().norm(), std::abs(shortfall_.z()), statistics_.outside() ? 1.0 : 0.0});
  }
  std::optional<double> total(std::string_view name) const override { return statistics_.total(name); }
  std::vector<bodies::DrawnLine> drawn(const bodies::Bodies& bodies) const override {
    return drawn_plan(settings_, now_, bodies.p_GB[settings_.hull].z());
  }
  std::vector<bodies::RunFigure> figures() const override {
    std::vector<bodies::RunFigure> all = statistics_.figures();
    const std::string swinging = loss_.swinging();
    all.push_back({"swings_1", swinging.empty() ? 0.0 : 1.0, swinging.empty() ? "" : "control swings", swinging});
    return all;
  }

  void save(const bodies::Bodies& bodies, StateWriter out) const override;
  void restore(const StateReader& in) override;

 private:
  /// Keeps the true heading continuous.
  void follow_truth(const Vec3& position) {
    const double heading = position_.z() + wrapped(position.z() - position_.z());
    position_ = {position.x(), position.y(), heading};
  }

  std::vector<ThrusterCommand> thrusts(int DpChannels::*thrust, int DpChannels::*angle) const {
    std::vector<ThrusterCommand> found;
    for (const DpChannels& at : indices_)
      found.push_back(
          {(*channels_)[at.*thrust], at.*angle < 0 ? 0 : (*channels_)[at.*angle], (*channels_)[at.works] != 0});
    return found;
  }
  std::vector<ThrusterCommand> measured_thrusts() const {
    return thrusts(&DpChannels::actual_thrust, &DpChannels::actual_angle);
  }

  /// Ends the run where the vessel is lost: too far from its reference, or turned by more than half a turn.
  void judge(double t) const {
    const Vec3 off = position_ - reference_.position();
    const double offset = off.head<2>().norm(), turn = std::abs(off.z());
    const bool near = offset <= settings_.most_offset;
    if (position_.allFinite() && near && turn <= k_pi) return;
    throw SimulationError(fmt::format(
        "at {:g} s dynamic positioning has lost the vessel: it is {:.3g} m from its reference, {} the most_offset of "
        "{:g} m, and {:.3g} deg from the heading of its reference. {}",
        t, offset, near ? "within" : "more than", settings_.most_offset, turn / k_deg, loss_.text()));
  }

  /// The known load in the vessel's axes, by the estimated heading.
  Vec3 known_load(const bodies::Bodies& bodies, double t) const {
    if (!settings_.known_load) return Vec3::Zero();
    const Wrench load = settings_.known_load(bodies, t);
    return plane_rotation(observer_.position().z()).transpose() * Vec3(load.force.x(), load.force.y(), load.torque.z());
  }

  void control(const bodies::Bodies& bodies, double t) {
    const Vec3 known = known_load(bodies, t);
    observer_.predict(impulse_ / elapsed_ + known, elapsed_);
    observer_.correct(sensors_.sample(), elapsed_);
    const PositioningPlan::Target target = settings_.plan.at(t);
    reference_.advance(target.position, target.rate, elapsed_);
    wanted_ = controller_.load(observer_, reference_, known);
    if (!wanted_.allFinite())
      throw SimulationError(
          fmt::format("at {:g} s the load that dynamic positioning wants left finite numbers: the control diverges; "
                      "allowed: a lower <control bandwidth>, or a shorter sensor_period or sensor_delay",
                      t));
    const AllocatedThrust allocated =
        allocation_.allocate(wanted_, thrusts(&DpChannels::thrust, &DpChannels::angle), elapsed_);
    for (std::size_t k = 0; k < indices_.size(); ++k) {
      channels_->set(indices_[k].thrust, allocated.commands[k].thrust);
      if (indices_[k].angle >= 0) channels_->set(indices_[k].angle, allocated.commands[k].angle);
    }
    shortfall_ = allocated.shortfall;
    saturated_ = allocated.saturated ? 1 : 0;
    const Vec3 in_G = plane_rotation(observer_.position().z()) * wanted_;
    loss_.add(in_G.head<2>(), in_G.z(), kind_of(allocated), elapsed_);
    controller_.integrate(observer_, reference_, shortfall_, elapsed_);
    impulse_.setZero();
    elapsed_ = 0;
  }

  Shortfall kind_of(const AllocatedThrust& allocated) const {
    if (!allocated.saturated) return Shortfall::none;
    const PlaneLoad& missing = allocated.shortfall;
    const Vec2 scales = allocation_.scales();
    const bool force = missing.head<2>().norm() / scales.x() >= std::abs(missing.z()) / scales.y();
    return force ? Shortfall::force : Shortfall::moment;
  }

  StationSample station(double t) {
    const Vec3 off = position_ - settings_.plan.at(t).position;
    last_ = {off.head<2>().norm(), off.z(), 0, saturated_ != 0, shortfall_.head<2>().norm(), std::abs(shortfall_.z())};
    for (const ThrusterCommand& thrust : measured_thrusts()) last_.thrust_use += std::abs(thrust.thrust) / most_thrust_;
    return last_;
  }

  DpSettings settings_;
  Allocation allocation_;
  std::shared_ptr<Channels> channels_;
  std::vector<DpChannels> indices_;
  PositionSensors sensors_;
  PassiveObserver observer_;
  ReferenceFilter reference_;
  PositionController controller_;
  StationStatistics statistics_;
  LossOfStation loss_;
  double most_thrust_ = 0;                               ///< sum of all limits [N]
  Vec3 position_;                                        ///< true position, heading continuous
  double now_;                                           ///< time at the end of the last substep [s]
  Vec3 acting_ = Vec3::Zero(), impulse_ = Vec3::Zero();  ///< load of the thrusters; its integral since the last sample
  double elapsed_ = 0;                                   ///< time since the last sample [s]
  long due_ = 1;                                         ///< the period at whose end the next sample is taken
  Vec3 wanted_ = Vec3::Zero(), shortfall_ = Vec3::Zero();
  int saturated_ = 0;
  StationSample last_;
};

void Dp::save(const bodies::Bodies& /*bodies*/, StateWriter out) const {
  sensors_.save(out.group("sensors"));
  observer_.save(out.group("observer"));
  reference_.save(out.group("reference"));
  controller_.save(out.group("controller"));
  statistics_.save(out.group("statistics"));
  loss_.save(out.group("loss"));
  out.add("position", position_);
  out.add("acting", acting_);
  out.add("impulse", impulse_);
  out.add("elapsed", elapsed_);
  out.add("due", due_);
  out.add("shortfall", shortfall_);
  out.add("wanted", wanted_);
  out.add("saturated", saturated_);
}

void Dp::restore(const StateReader& in) {
  sensors_.restore(in.group("sensors"));
  observer_.restore(in.group("observer"));
  reference_.restore(in.group("reference"));
  controller_.restore(in.group("controller"));
  statistics_.restore(in.group("statistics"));
  loss_.restore(in.group("loss"));
  in.get("position", position_);
  in.get("acting", acting_);
  in.get("impulse", impulse_);
  in.get("elapsed", elapsed_);
  in.get("due", due_);
  in.get("shortfall", shortfall_);
  in.get("wanted", wanted_);
  in.get("saturated", saturated_);
}

}  // namespace

std::unique_ptr<bodies::Module> make_dp(const DpSettings& settings, Allocation allocation,
                                        const std::shared_ptr<Channels>& channels) {
  const PassiveObserver observer(settings.observer, settings.position, settings.velocity);
  if (!(observer.spectral_radius(settings.sensors.period) < 1))
    throw InputError(
        fmt::format("the observer of dynamic positioning does not converge with samples every {:g} s; "
                    "allowed: a shorter sensor_period, or no wave_period",
                    settings.sensors.period));
  return std::make_unique<Dp>(settings, std::move(allocation), channels);
}

}  // namespace nilas::vessel
