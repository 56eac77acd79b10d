#include "hydro/manoeuvring/manoeuvring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/choices/defaults.h"
#include "hydro/manoeuvring/vessel_in_plane.h"

namespace nilas::hydro {

namespace {

class Manoeuvring : public bodies::ForceModule {
 public:
  Manoeuvring(ManoeuvringSettings settings, std::shared_ptr<Channels> commands)
      : settings_(std::move(settings)),
        commands_(std::move(commands)),
        added_(planar_added_mass(settings_.ship, settings_.density)),
        rps_(settings_.rps) {
    rudder_channel_ = commands_->add(k_rudder_channel, "rad", 0);
    propeller_channel_ = commands_->add(k_propeller_channel, "1/s", rps_);
    thrust_channel_ = commands_->add_measured(k_thrust_channel, "N", 0);
  }

  std::string name() const override { return "manoeuvring"; }
  bodies::VesselLoad load_on_vessel() const override { return bodies::VesselLoad::water; }
  /// The propeller sets the vessel in motion, but free ice at no one velocity.
  std::optional<Vec3> drift() const override { return Vec3::Zero(); }
  std::optional<Mat6> vessel_added_mass() const override { return added_mass(added_, settings_.midship); }

  void add_forces(const bodies::Bodies& bodies, double /*t*/, bodies::Wrenches& out) override {
    const VesselInPlane seen = plane(bodies);
    PlanarLoads loads = ship_loads(settings_.ship, settings_.density, seen.motion, rudder_, rps_).sum();
    loads += kirchhoff_terms_in_model(settings_.ship, added_, seen.motion);
    const Vec2 force = loads.X * seen.ahead + loads.Y * seen.starboard();
    Wrench& own = out[static_cast<std::size_t>(settings_.vessel)];
    own.force.head<2>() += force;
    own.torque.z() += cross2(seen.arm.head<2>(), force) - loads.N;
  }

  void end_substep(const bodies::Bodies& bodies, double /*t*/, double h) override {
    const double wanted_rudder = std::clamp((*commands_)[rudder_channel_], -settings_.max_rudder, settings_.max_rudder);
    const double most = settings_.ship.max_rps;
    const double least = std::holds_alternative<ThrustCurve>(settings_.ship.propulsion) ? -most : 0;
    rudder_ = follow(rudder_, wanted_rudder, settings_.rudder_rate * h);
    rps_ = follow(rps_, std::clamp((*commands_)[propeller_channel_], least, most), settings_.propeller_rate * h);
    seen_ = plane(bodies);
    const ShipLoads loads = ship_loads(settings_.ship, settings_.density, seen_.motion, rudder_, rps_);
    thrust_ = loads.thrust;
    commands_->set(thrust_channel_, loads.jet);
    if (is_outside(seen_)) outside_ += h;
  }

  std::vector<std::string> columns() const override {
    return {"rudder_deg", "propeller_rate_1_s", "propeller_thrust_N", "surge_m_s", "sway_m_s"};
  }
  void append_values(std::vector<double>& values) const override {
    for (const double x : {rudder_ / k_deg, rps_, thrust_, seen_.motion.u, -seen_.motion.v}) values.push_back(x);
  }
  std::vector<bodies::RunFigure> figures() const override {
    if (!(outside_ > 0)) return {};
    return {{"outside_of_range_s", outside_, "manoeuvring model",
             fmt::format("was outside of its range for {:.4g} s: drift above {:g} deg, or r L/U above {:g}", outside_,
                         k_mmg_drift / k_deg, k_mmg_yaw_rate)}};
  }

  void save(const bodies::Bodies& /*bodies*/, StateWriter out) const override {
    out.add("rudder", rudder_);
    out.add("rps", rps_);
    out.add("outside", outside_);
  }
  void restore(const StateReader& in) override {
    in.get("rudder", rudder_);
    in.get("rps", rps_);
    in.get("outside", outside_);
  }

 private:
  VesselInPlane plane(const bodies::Bodies& bodies) const {
    return vessel_in_plane(bodies, settings_.vessel, settings_.midship, settings_.current);
  }
  static double follow(double from, double to, double most) { return from + std::clamp(to - from, -most, most); }
  /// Whether the polynomials are continued beyond what tests cover, while the vessel moves ahead or astern.
  bool is_outside(const VesselInPlane& seen) const {
    constexpr double k_at_rest = 0.01;  // Froude number below which nothing depends on the model
    const double speed = seen.speed(), L = settings_.ship.length();
    if (!(speed > k_at_rest * std::sqrt(defaults::k_gravity * L))) return false;
    return std::abs(seen.drift()) > k_mmg_drift || std::abs(seen.motion.r) * L / speed > k_mmg_yaw_rate;
  }

  ManoeuvringSettings settings_;
  std::shared_ptr<Channels> commands_;
  PlanarAddedMass added_;
  int rudder_channel_ = -1, propeller_channel_ = -1, thrust_channel_ = -1;
  double rudder_ = 0;   ///< [rad]
  double rps_ = 0;      ///< [1/s]
  double outside_ = 0;  ///< time outside of the model's range [s]
  // For the columns of the step that ended.
  VesselInPlane seen_;
  double thrust_ = 0;  ///< [N]
};

}  // namespace

std::unique_ptr<bodies::ForceModule> make_manoeuvring(ManoeuvringSettings settings,
                                                      std::shared_ptr<Channels> commands) {
  NILAS_DEMAND(settings.ship.length() > 0 && settings.ship.max_rps > 0 && commands);
  return std::make_unique<Manoeuvring>(std::move(settings), std::move(commands));
}

}  // namespace nilas::hydro
