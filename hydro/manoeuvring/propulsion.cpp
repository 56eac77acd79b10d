#include "hydro/manoeuvring/propulsion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "hydro/manoeuvring/mmg_hull.h"

namespace nilas::hydro {

double propeller_inflow(const OpenWaterPropeller& propeller, double length, const PlanarMotion& motion) {
  if (!(motion.u > 0)) return 0;
  const double speed = std::hypot(motion.u, motion.v);
  const double drift = std::atan2(-motion.v, motion.u);
  const double rate = std::clamp(motion.r * length / speed, -k_mmg_yaw_rate, k_mmg_yaw_rate);
  const double at_propeller = drift - propeller.x_P * rate;
  const double C_2 = at_propeller >= 0 ? propeller.C_2_plus : propeller.C_2_minus;
  const double change = 1 + (1 - std::exp(-propeller.C_1 * std::abs(at_propeller))) * (C_2 - 1);
  return (1 - propeller.w_P0) * change * motion.u;
}

double propeller_thrust(const OpenWaterPropeller& propeller, double density, double inflow, double rps) {
  const double tip = rps * propeller.diameter;  // n D
  return density * propeller.diameter * propeller.diameter *
         (propeller.k_0 * tip * tip + propeller.k_1 * tip * inflow + propeller.k_2 * inflow * inflow);
}

double net_thrust(const ThrustCurve& curve, double u, double rps) {
  const double s = rps / curve.max_rps, x = u / curve.max_speed;
  return curve.pull * (s * std::abs(s) - curve.a_1 * std::abs(s) * x - curve.a_2 * x * std::abs(x));
}

double bollard_pull(double power, double diameter, int screws) {
  constexpr std::array k_by_screws{0.78, 0.98, 1.12};  // [kN/(kW m)^(2/3)]
  constexpr double k_kilo = 1000;
  if (screws < 1 || screws > static_cast<int>(k_by_screws.size()))
    throw InputError("a bollard pull by power: found " + std::to_string(screws) + " screws; allowed: 1, 2 or 3");
  return k_kilo * k_by_screws.at(static_cast<std::size_t>(screws - 1)) * std::pow(power / k_kilo * diameter, 2.0 / 3);
}

}  // namespace nilas::hydro
