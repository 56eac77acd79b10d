#include "hydro/manoeuvring/manoeuvring_ship.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace nilas::hydro {

namespace {

PlanarLoads hull_loads_of(const ManoeuvringShip& ship, double density, const PlanarMotion& motion, double angle) {
  if (const auto* mmg = std::get_if<MmgHull>(&ship.hull)) return mmg_hull_loads(*mmg, density, motion);
  return derivatives_loads(std::get<DerivativesHull>(ship.hull), density, motion, angle);
}

/// Surge force of hull and propulsion on a straight course.
double surplus_ahead(const ManoeuvringShip& ship, double density, double speed, double rps) {
  const ShipLoads loads = ship_loads(ship, density, {speed, 0, 0}, 0, rps);
  return loads.hull.X + loads.propeller.X;
}

/// The largest speed up to `speed` that the largest rate of revolutions holds.
double fastest(const ManoeuvringShip& ship, double density, double speed) {
  double low = 0, high = speed;
  for (double middle = 0.5 * speed; middle > low && middle < high; middle = 0.5 * (low + high))
    (surplus_ahead(ship, density, middle, ship.max_rps) >= 0 ? low : high) = middle;
  return low;
}

void scale_hull(MmgHull& hull, double ratio) {
  hull.length *= ratio;
  hull.draught *= ratio;
}

void scale_hull(DerivativesHull& hull, double ratio) {
  const double root = std::sqrt(ratio), force = ratio * ratio * ratio;
  hull.length *= ratio;
  hull.draught *= ratio;
  hull.mass *= force;
  hull.reference_speed *= root;
  if (hull.scaling != DerivativeScaling::si) return;
  hull.X_udot *= force;
  hull.Y_vdot *= force;
  hull.Y_rdot *= force * ratio;
  hull.N_vdot *= force * ratio;
  hull.N_rdot *= force * ratio * ratio;
  for (DerivativeTerm& term : hull.terms) {
    term.value *= term.load == DerivativeTerm::Load::N ? force * ratio : force;
    const auto order = [&](std::size_t k) { return term.powers.at(k) + term.absolute_powers.at(k); };
    for (int k = 0; k < order(0) + order(1); ++k) term.value /= root;
    for (int k = 0; k < order(2); ++k) term.value *= root;
  }
}

}  // namespace

ManoeuvringShip scaled(ManoeuvringShip ship, double ratio) {
  const double root = std::sqrt(ratio);
  std::visit([&](auto& hull) { scale_hull(hull, ratio); }, ship.hull);
  if (auto* propeller = std::get_if<OpenWaterPropeller>(&ship.propulsion)) propeller->diameter *= ratio;
  if (auto* curve = std::get_if<ThrustCurve>(&ship.propulsion)) {
    curve->pull *= ratio * ratio * ratio;
    curve->max_speed *= root;
    curve->max_rps /= root;
    curve->diameter *= ratio;
  }
  if (ship.rudder) ship.rudder->area *= ratio * ratio;
  ship.max_rps /= root;
  return ship;
}

double ManoeuvringShip::length() const {
  return std::visit([](const auto& any) { return any.length; }, hull);
}

bool ManoeuvringShip::steers() const {
  if (rudder) return true;
  const auto* given = std::get_if<DerivativesHull>(&hull);
  constexpr std::size_t k_angle = 3;  // index of the rudder angle's powers
  return given && std::any_of(given->terms.begin(), given->terms.end(), [](const DerivativeTerm& term) {
           return term.powers[k_angle] + term.absolute_powers[k_angle] > 0;
         });
}

PlanarLoads ShipLoads::sum() const {
  PlanarLoads all = hull;
  all += propeller;
  all += rudder;
  return all;
}

ShipLoads ship_loads(const ManoeuvringShip& ship, double density, const PlanarMotion& motion, double angle,
                     double rps) {
  const double L = ship.length();
  ShipLoads loads;
  loads.hull = hull_loads_of(ship, density, motion, angle);
  double inflow = std::max(motion.u, 0.0), jet = 0;  // the jet in T / (rho D^2)
  if (const auto* propeller = std::get_if<OpenWaterPropeller>(&ship.propulsion)) {
    inflow = propeller_inflow(*propeller, L, motion);
    loads.thrust = propeller_thrust(*propeller, density, inflow, std::max(rps, 0.0));
    loads.propeller.X = (1 - propeller->t_P) * loads.thrust;
    loads.jet = loads.thrust;
    jet = loads.thrust / (density * propeller->diameter * propeller->diameter);
  } else {
    const auto& curve = std::get<ThrustCurve>(ship.propulsion);
    loads.thrust = net_thrust(curve, motion.u, rps);
    loads.propeller.X = loads.thrust;
    loads.hull.X -= hull_loads_of(ship, density, {motion.u, 0, 0}, 0).X;
    loads.jet = loads.thrust - net_thrust(curve, motion.u, 0);
    if (ship.rudder && curve.diameter > 0) jet = loads.jet / (density * curve.diameter * curve.diameter);
  }
  if (ship.rudder) loads.rudder = mmg_rudder_loads(*ship.rudder, density, L, motion, angle, inflow, jet);
  return loads;
}

PlanarAddedMass planar_added_mass(const ManoeuvringShip& ship, double density) {
  if (const auto* mmg = std::get_if<MmgHull>(&ship.hull)) return mmg_added_mass(*mmg, density);
  return derivatives_added_mass(std::get<DerivativesHull>(ship.hull), density);
}

Mat6 added_mass(const PlanarAddedMass& planar, double arm) {
  constexpr int k_surge = 0, k_sway = 1, k_yaw = 5;
  // Sway and yaw are both to the other side in these axes, so their coupling keeps its sign.
  Mat6 matrix = Mat6::Zero();
  matrix(k_surge, k_surge) = planar.surge;
  matrix(k_sway, k_sway) = planar.sway;
  matrix(k_sway, k_yaw) = matrix(k_yaw, k_sway) = planar.sway_yaw + arm * planar.sway;
  matrix(k_yaw, k_yaw) = planar.yaw + 2 * arm * planar.sway_yaw + arm * arm * planar.sway;
  return matrix;
}

PlanarLoads kirchhoff_terms_in_model(const ManoeuvringShip& ship, const PlanarAddedMass& added,
                                     const PlanarMotion& motion) {
  const double munk = (added.sway - added.surge) * motion.u * motion.v;
  if (std::holds_alternative<MmgHull>(ship.hull)) return {0, 0, munk + added.sway_yaw * motion.u * motion.r};
  return {-(added.sway * motion.v + added.sway_yaw * motion.r) * motion.r, added.surge * motion.u * motion.r,
          munk + added.sway_yaw * motion.u * motion.r};
}

double self_propulsion(const ManoeuvringShip& ship, double density, double speed) {
  NILAS_DEMAND(speed >= 0);
  if (speed == 0) return 0;
  if (surplus_ahead(ship, density, speed, ship.max_rps) < 0)
    throw InputError(fmt::format("the propeller holds {:.4g} m/s at its largest rate of {:g} 1/s; found {:g} m/s",
                                 fastest(ship, density, speed), ship.max_rps, speed));
  double low = 0, high = ship.max_rps;
  for (double middle = 0.5 * high; middle > low && middle < high; middle = 0.5 * (low + high))
    (surplus_ahead(ship, density, speed, middle) >= 0 ? high : low) = middle;
  return high;
}

}  // namespace nilas::hydro
