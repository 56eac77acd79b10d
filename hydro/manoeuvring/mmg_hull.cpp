#include "hydro/manoeuvring/mmg_hull.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace nilas::hydro {

const double k_mmg_drift = 35 * k_deg;
const double k_mmg_yaw_rate = 2;

PlanarLoads mmg_hull_loads(const MmgHull& hull, double density, const PlanarMotion& motion) {
  const double L = hull.length, speed = std::hypot(motion.u, motion.v);
  // The speed that makes the velocities dimensionless; it is not below the limit of the yaw rate.
  const double scale = std::max(speed, std::abs(motion.r) * L / k_mmg_yaw_rate);
  if (!(scale > 0)) return {};
  const double most = std::sin(k_mmg_drift);
  const double v = std::clamp(motion.v / scale, -most, most), r = motion.r * L / scale;
  const double ahead = std::clamp(motion.u / (scale * std::cos(k_mmg_drift)), -1.0, 1.0);
  const double v2 = v * v, r2 = r * r, share = speed / scale;
  const double X =
      ahead * (-hull.R_0 * share * share + hull.X_vv * v2 + hull.X_rr * r2 + hull.X_vvvv * v2 * v2) + hull.X_vr * v * r;
  const double Y = hull.Y_v * v + hull.Y_vvv * v2 * v + hull.Y_vrr * v * r2 +
                   ahead * (hull.Y_r * r + hull.Y_vvr * v2 * r + hull.Y_rrr * r2 * r);
  const double N = ahead * (hull.N_v * v + hull.N_vvv * v2 * v + hull.N_vrr * v * r2) + hull.N_r * r +
                   hull.N_vvr * v2 * r + hull.N_rrr * r2 * r;
  const double force = 0.5 * density * L * hull.draught * scale * scale;
  return {force * X, force * Y, force * L * N};
}

PlanarAddedMass mmg_added_mass(const MmgHull& hull, double density) {
  const double mass = 0.5 * density * hull.length * hull.length * hull.draught;
  return {hull.m_x * mass, hull.m_y * mass, 0, hull.J_z * mass * hull.length * hull.length};
}

}  // namespace nilas::hydro
