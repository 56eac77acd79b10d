#include "hydro/manoeuvring/derivatives_hull.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "hydro/manoeuvring/mmg_hull.h"

namespace nilas::hydro {

namespace {

/// The units of a system at one instant.
struct DerivativeUnits {
  double speed = 1, rate = 1;    ///< [m/s], [rad/s]
  double force = 1, moment = 1;  ///< [N], [N m]
};

DerivativeUnits units_of(const DerivativesHull& hull, double density, const PlanarMotion& motion) {
  const double L = hull.length;
  switch (hull.scaling) {
    case DerivativeScaling::si:
      return {};
    case DerivativeScaling::bis:
      return {std::sqrt(hull.gravity * L), std::sqrt(hull.gravity / L), hull.mass * hull.gravity,
              hull.mass * hull.gravity * L};
    case DerivativeScaling::prime:
    case DerivativeScaling::prime_draught: {
      const double other = hull.scaling == DerivativeScaling::prime ? L : hull.draught;
      const double speed = std::max(std::hypot(motion.u, motion.v), std::abs(motion.r) * L / k_mmg_yaw_rate);
      const double force = 0.5 * density * L * other * speed * speed;
      return {speed, speed / L, force, force * L};
    }
  }
  return {};
}

/// Least deviation of u from the reference speed, over U: that at half of the reference speed. Below it the expansion
/// about that speed would give loads that do not vanish at rest, and those of third order would have no bound.
constexpr double k_least_deviation = -1;

double power_of(double x, int exponent) {
  double product = 1;
  for (int k = 0; k < exponent; ++k) product *= x;
  return product;
}

}  // namespace

std::optional<DerivativeTerm> derivative_term(const std::string& name) {
  constexpr std::string_view k_loads = "XYN", k_variables = "uvrd";
  DerivativeTerm term;
  if (name.size() < 3 || name[1] != '_') return std::nullopt;
  const auto load = k_loads.find(name[0]);
  if (load == std::string_view::npos) return std::nullopt;
  term.load = static_cast<DerivativeTerm::Load>(load);
  const std::string rest = name.substr(2);
  if (rest == "0") return term;
  bool absolute = false;
  for (const char letter : rest) {
    if (letter == '|') {
      absolute = !absolute;
      continue;
    }
    const auto variable = k_variables.find(letter);
    if (variable == std::string_view::npos) return std::nullopt;
    ++(absolute ? term.absolute_powers : term.powers).at(variable);
  }
  const bool empty = rest.find_first_not_of('|') == std::string::npos;
  return absolute || empty ? std::nullopt : std::optional(term);
}

PlanarLoads derivatives_loads(const DerivativesHull& hull, double density, const PlanarMotion& motion, double rudder) {
  const DerivativeUnits units = units_of(hull, density, motion);
  if (!(units.speed > 0)) return {};
  const bool prime = hull.scaling == DerivativeScaling::prime || hull.scaling == DerivativeScaling::prime_draught;
  double deviation = (motion.u - hull.reference_speed) / units.speed;
  if (prime) deviation = std::max(deviation, k_least_deviation);
  const std::array<double, 4> x{deviation, motion.v / units.speed, motion.r / units.rate, rudder};
  std::array<double, 3> sums{};
  for (const DerivativeTerm& term : hull.terms) {
    double product = term.value;
    for (std::size_t k = 0; k < x.size(); ++k)
      product *= power_of(x[k], term.powers[k]) * power_of(std::abs(x[k]), term.absolute_powers[k]);
    sums.at(static_cast<std::size_t>(term.load)) += product;
  }
  return {units.force * sums[0], units.force * sums[1], units.moment * sums[2]};
}

PlanarAddedMass derivatives_added_mass(const DerivativesHull& hull, double density) {
  const double L = hull.length;
  double mass = 1, arm = 1;
  switch (hull.scaling) {
    case DerivativeScaling::si:
      break;
    case DerivativeScaling::bis:
      mass = hull.mass;
      arm = L;
      break;
    case DerivativeScaling::prime:
      mass = 0.5 * density * L * L * L;
      arm = L;
      break;
    case DerivativeScaling::prime_draught:
      mass = 0.5 * density * L * L * hull.draught;
      arm = L;
      break;
  }
  return {-hull.X_udot * mass, -hull.Y_vdot * mass, -0.5 * (hull.Y_rdot + hull.N_vdot) * mass * arm,
          -hull.N_rdot * mass * arm * arm};
}

}  // namespace nilas::hydro
