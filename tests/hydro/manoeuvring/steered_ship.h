#pragma once
/// A ship that the modules of manoeuvring and steering command, and that Runge and Kutta's method moves.
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/bodies/bodies.h"
#include "hydro/manoeuvring/manoeuvring.h"
#include "hydro/manoeuvring/ship_presets.h"
#include "hydro/manoeuvring/steering.h"
#include "tests/hydro/manoeuvring/ship_motion.h"

namespace nilas::test {

/// Puts the vessel, body 0, where the plane's state says, in axes with y to port and the heading to port; the water
/// moves with `current`.
inline void place_vessel(bodies::Bodies& bodies, const PlanarState& s, double x_G, const Vec3& offset = Vec3::Zero(),
                         const Vec3& current = Vec3::Zero()) {
  const Quat q(Eigen::AngleAxisd(-s.heading, Vec3::UnitZ()));
  const Vec3 arm = q * Vec3(x_G, 0, 0);
  bodies.set_pose(0, Vec3(s.x, -s.y, 0) + arm + offset, q);
  bodies.w_GB[0] = Vec3(0, 0, -s.motion.r);
  bodies.v_GB[0] = q * Vec3(s.motion.u, -s.motion.v, 0) + bodies.w_GB[0].cross(arm) + current;
}

inline bodies::Bodies one_vessel(double mass) {
  bodies::Bodies bodies;
  bodies::BodySpec spec;
  spec.name = "ship";
  spec.kind = bodies::BodyKind::vessel;
  spec.motion = bodies::Motion::articulated;
  spec.shape = std::make_shared<const geometry::Shape>(geometry::box_shape(Vec3(10, 2, 1)));
  spec.mass = mass;
  spec.inertia_B = mass * Mat3::Identity();
  bodies.add(spec);
  return bodies;
}

class SteeredShip {
 public:
  SteeredShip(PlanarShip ship, hydro::ManoeuvringSettings settings, double speed)
      : ship_(std::move(ship)), bodies_(one_vessel(ship_.mass)), settings_(std::move(settings)) {
    state.motion.u = speed;
    settings_.ship = ship_.model;
    settings_.density = ship_.density;
    settings_.midship = -ship_.x_G;
    machines = make_manoeuvring(settings_, commands);
    rps_ = settings_.rps;
  }
  void steer(std::unique_ptr<hydro::Manoeuvre> manoeuvre, double start = 0) {
    hydro::SteeringSettings settings;
    settings.midship = -ship_.x_G;
    settings.current = settings_.current;
    settings.start = start;
    steering = make_steering(settings, std::move(manoeuvre), commands);
  }
  /// Goes on for `time` [s] in substeps of h [s].
  void go(double time, double h) {
    const auto steps = static_cast<int>(std::lround(time / h));
    for (int k = 0; k < steps; ++k) {
      state = planar_step(ship_, state, rudder_, rps_, h);
      t_ += h;
      place_vessel(bodies_, state, ship_.x_G, t_ * settings_.current, settings_.current);
      machines->end_substep(bodies_, t_, h);
      steering->end_substep(bodies_, t_, h);
      std::vector<double> values;
      machines->append_values(values);
      rudder_ = values[0] * k_deg;
      rps_ = values[1];
    }
  }
  double rudder() const { return rudder_; }
  double rps() const { return rps_; }
  const bodies::Bodies& bodies() const { return bodies_; }
  /// A figure of the manoeuvre; fails with NaN where there is none.
  double figure(const std::string& name) const {
    for (const bodies::RunFigure& f : steering->figures())
      if (f.name == name) return f.value;
    return std::nan("");
  }
  std::string text(const std::string& name) const {
    for (const bodies::RunFigure& f : steering->figures())
      if (f.name == name) return f.text;
    return "no such figure";
  }

  PlanarState state;
  std::shared_ptr<Channels> commands = std::make_shared<Channels>();
  std::unique_ptr<bodies::ForceModule> machines;
  std::unique_ptr<bodies::Module> steering;

 private:
  PlanarShip ship_;
  bodies::Bodies bodies_;
  hydro::ManoeuvringSettings settings_;
  double rudder_ = 0, rps_ = 0, t_ = 0;
};

/// KVLCC2 at 15.5 knots with its rudder machine.
inline SteeredShip kvlcc2_under_way(const Vec3& current = Vec3::Zero()) {
  constexpr double k_speed = 15.5 * 1852 / 3600;  // [m/s]
  PlanarShip ship = full_scale_kvlcc2(hydro::kvlcc2(320));
  hydro::ManoeuvringSettings settings;
  settings.rudder_rate = 2.34 * k_deg;
  settings.max_rudder = 35 * k_deg;
  settings.propeller_rate = 0.1;
  settings.rps = hydro::self_propulsion(ship.model, ship.density, k_speed);
  settings.current = current;
  return {std::move(ship), settings, k_speed};
}

}  // namespace nilas::test
