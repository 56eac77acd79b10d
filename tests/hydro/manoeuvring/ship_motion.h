#pragma once
/// A ship on its own in the horizontal plane, integrated by Runge and Kutta: the oracle for the module of manoeuvring.
#include <array>
#include <cmath>
#include <functional>

#include "hydro/manoeuvring/manoeuvring_ship.h"

namespace nilas::test {

/// A rigid ship with the equations of Yasukawa & Yoshimura 2015, eq. 4.
struct PlanarShip {
  hydro::ManoeuvringShip model;
  double density = 1025;  ///< [kg/m^3]
  double mass = 0;        ///< [kg]
  double inertia = 0;     ///< about the vertical axis through the centre of mass [kg m^2]
  double x_G = 0;         ///< centre of mass ahead of midship [m]
};

/// KVLCC2 at full scale: displacement 312600 m^3, radius of gyration L/4, x_G 11.2 m.
inline PlanarShip full_scale_kvlcc2(hydro::ManoeuvringShip model) {
  const double L = model.length(), mass = 312600.0 * 1025;
  return {std::move(model), 1025, mass, mass * L * L / 16, 11.2};
}

/// Accelerations (u', v', r') from the model's equations.
inline Vec3 planar_acceleration(const PlanarShip& ship, const hydro::PlanarMotion& m, double rudder, double rps) {
  const hydro::PlanarAddedMass added = planar_added_mass(ship.model, ship.density);
  const hydro::PlanarLoads on = ship_loads(ship.model, ship.density, m, rudder, rps).sum();
  const double mx = ship.mass + added.surge, my = ship.mass + added.sway, lever = ship.x_G * ship.mass;
  Mat3 matrix;
  matrix << mx, 0, 0, 0, my, lever, 0, lever, ship.inertia + ship.x_G * lever + added.yaw;
  const Vec3 right(on.X + my * m.v * m.r + lever * m.r * m.r, on.Y - mx * m.u * m.r, on.N - lever * m.u * m.r);
  return matrix.inverse() * right;
}

/// Position of midship, heading and motion; x north, y east, heading and yaw rate positive to starboard.
struct PlanarState {
  double x = 0, y = 0, heading = 0;
  hydro::PlanarMotion motion;
};

/// One step of Runge and Kutta's method of order 4 with constant rudder angle and rate of revolutions.
inline PlanarState planar_step(const PlanarShip& ship, const PlanarState& s, double rudder, double rps, double h) {
  using Rates = std::array<double, 6>;
  const auto rates = [&](const Rates& q) -> Rates {
    const hydro::PlanarMotion m{q[3], q[4], q[5]};
    const Vec3 a = planar_acceleration(ship, m, rudder, rps);
    const double c = std::cos(q[2]), d = std::sin(q[2]);
    return {m.u * c - m.v * d, m.u * d + m.v * c, m.r, a[0], a[1], a[2]};
  };
  const Rates q{s.x, s.y, s.heading, s.motion.u, s.motion.v, s.motion.r};
  const auto moved = [&](const Rates& k, double by) {
    Rates to = q;
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += by * k[i];
    return to;
  };
  const Rates k1 = rates(q), k2 = rates(moved(k1, 0.5 * h)), k3 = rates(moved(k2, 0.5 * h)), k4 = rates(moved(k3, h));
  Rates end = q;
  for (std::size_t i = 0; i < end.size(); ++i) end[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  return {end[0], end[1], end[2], {end[3], end[4], end[5]}};
}

}  // namespace nilas::test
