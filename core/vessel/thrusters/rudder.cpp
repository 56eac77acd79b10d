#include "core/vessel/thrusters/rudder.h"

#include <algorithm>

namespace nilas::vessel {

RudderCoefficients rudder_coefficients(double aspect_ratio, double attack) {
  constexpr double k_shift = 0.7, k_width = 1.7;  // of the lift's slope over the aspect ratio
  constexpr double k_cross_flow = 1;              // C_Q
  constexpr double k_friction = 0.008;            // C_D0, both sides
  const double s = std::sin(attack), shifted = aspect_ratio + k_width;
  const double slope = 2 * k_pi * aspect_ratio * (aspect_ratio + k_shift) / (shifted * shifted);
  const double lift = slope * s + k_cross_flow * s * std::abs(s) * std::cos(attack);
  return {lift, lift * lift / (k_pi * aspect_ratio) + k_cross_flow * std::abs(s * s * s) + k_friction};
}

Slipstream slipstream_at(const Rudder& rudder, double thrust, double advance) {
  constexpr double k_contraction = 0.14, k_growth = 1.5;  // Soeding's contraction
  const double r0 = 0.5 * rudder.diameter, disc = k_pi * r0 * r0;
  const double ahead = std::max(advance, 0.0);
  const double far = std::sqrt(ahead * ahead + 2 * std::max(thrust, 0.0) / (rudder.water_density * disc));
  if (far == 0) return {r0, 0};
  const double k = std::sqrt(0.5 * (1 + ahead / far)), c = std::pow(rudder.behind / r0, k_growth);
  const double near = k_contraction * k * k * k;
  const double r = (near + k * c) / (near + c);
  return {r * r0, far * (k / r) * (k / r)};
}

/// Force on a part of the rudder's area in a flow from ahead.
static Vec2 force_in_flow(const Rudder& rudder, double area, double angle, double speed, double sideways) {
  if (!(speed > 0)) return Vec2::Zero();
  const double drift = std::atan2(sideways, speed);  // moving to port, the rudder meets water from port
  const RudderCoefficients c = rudder_coefficients(rudder.aspect_ratio(), angle - drift);
  const double pressure = 0.5 * rudder.water_density * area * (speed * speed + sideways * sideways);
  const Vec2 along(-std::cos(drift), -std::sin(drift)), across(-std::sin(drift), std::cos(drift));
  return pressure * (c.drag * along + c.lift * across);
}

Vec2 rudder_force(const Rudder& rudder, double angle, double thrust, double advance, double sideways) {
  const double undisturbed = std::max(advance, 0.0);
  if (!(thrust > 0)) return force_in_flow(rudder, rudder.area, angle, undisturbed, sideways);
  const Slipstream stream = slipstream_at(rudder, thrust, advance);
  const double share = std::min(1.0, 2 * stream.radius / rudder.span);
  return force_in_flow(rudder, share * rudder.area, angle, stream.speed, sideways) +
         force_in_flow(rudder, (1 - share) * rudder.area, angle, undisturbed, sideways);
}

}  // namespace nilas::vessel
