#include "hydro/manoeuvring/mmg_rudder.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"
#include "hydro/manoeuvring/mmg_hull.h"

namespace nilas::hydro {

PlanarLoads mmg_rudder_loads(const MmgRudder& rudder, double density, double length, const PlanarMotion& motion,
                             double angle, double inflow, double jet) {
  constexpr double k_jet_factor = 8 / k_pi;  // of momentum theory: 8 K_T/(pi J^2)
  const double speed = std::hypot(motion.u, motion.v);
  const double drift = std::atan2(-motion.v, std::max(motion.u, speed * std::cos(k_mmg_drift)));
  const double across = speed * drift - rudder.l_R * length * motion.r;
  const double v_R = (across < 0 ? rudder.gamma_minus : rudder.gamma_plus) * across;
  const double behind = std::sqrt(std::max(inflow * inflow + k_jet_factor * jet, 0.0));
  const double slipstream = inflow + rudder.kappa * (behind - inflow);
  const double u_R =
      rudder.epsilon * std::sqrt(rudder.eta * slipstream * slipstream + (1 - rudder.eta) * inflow * inflow);
  const double normal =
      0.5 * density * rudder.area * rudder.f_alpha * (u_R * u_R + v_R * v_R) * std::sin(angle - std::atan2(v_R, u_R));
  const double side = normal * std::cos(angle);
  return {-(1 - rudder.t_R) * normal * std::sin(angle), -(1 + rudder.a_H) * side,
          -(rudder.x_R + rudder.a_H * rudder.x_H) * length * side};
}

}  // namespace nilas::hydro
