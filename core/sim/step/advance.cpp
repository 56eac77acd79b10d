#include "core/sim/step/advance.h"

#include "core/base/parallel.h"
#include "core/bodies/free_rotation.h"

namespace nilas::sim {

static Mat6 inverse_of(const Mat6& mass) { return mass.llt().solve(Mat6::Identity()); }

void free_velocities(const bodies::Bodies& bodies, const std::vector<Wrench>& loads, double h,
                     contact::Velocities& out) {
  out.v = bodies.v_GB;
  out.w = bodies.w_GB;
  for (int k = 0; k < bodies.size(); ++k) {
    if (!bodies.is_free(k)) continue;
    const auto b = static_cast<std::size_t>(k);
    const Mat3& R = bodies.R_GB[b];
    if (bodies.has_added_mass()) {
      Vec6 impulse_B;
      impulse_B << R.transpose() * (h * loads[b].force), R.transpose() * (h * loads[b].torque);
      const Vec6 change_B = bodies.whole_mass_B(k).llt().solve(impulse_B);
      out.v[b] += R * change_B.head<3>();
      out.w[b] += R * change_B.tail<3>();
      continue;
    }
    out.v[b] += h / bodies.mass[b] * loads[b].force;
    out.w[b] += R * (bodies.inertia_inverse_B[b] * (R.transpose() * (h * loads[b].torque)));
  }
}

void advance(bodies::Bodies& bodies, const contact::Velocities& velocities, double h, bool gyroscopic, int threads) {
  parallel_for(bodies.size(), threads, [&](std::ptrdiff_t i) {
    const int k = static_cast<int>(i);
    if (!bodies.is_free(k)) return;
    const auto b = static_cast<std::size_t>(k);
    bodies.v_GB[b] = velocities.v[b];
    bodies.w_GB[b] = velocities.w[b];
    if (gyroscopic && bodies.has_added_mass()) {
      Vec3 p = bodies.p_GB[b];
      const Mat6 mass = bodies.whole_mass_B(k);
      bodies::move_freely(p, bodies.q_GB[b], bodies.v_GB[b], bodies.w_GB[b], mass, inverse_of(mass), bodies.flow, h);
      bodies.set_pose(k, p, bodies.q_GB[b]);
      return;
    }
    if (gyroscopic)
      bodies::turn_freely(bodies.q_GB[b], bodies.w_GB[b], bodies.inertia_B[b], bodies.inertia_inverse_B[b], h);
    else
      bodies.q_GB[b] = bodies::exponential(h * velocities.w[b]) * bodies.q_GB[b];
    bodies.set_pose(k, bodies.p_GB[b] + h * velocities.v[b], bodies.q_GB[b]);
  });
}

void displace(bodies::Bodies& bodies, const contact::Velocities& pseudo, double h) {
  for (int k = 0; k < bodies.size(); ++k) {
    if (!bodies.is_free(k)) continue;
    const auto b = static_cast<std::size_t>(k);
    if (pseudo.v[b].isZero(0) && pseudo.w[b].isZero(0)) continue;
    bodies.set_pose(k, bodies.p_GB[b] + h * pseudo.v[b], bodies::exponential(h * pseudo.w[b]) * bodies.q_GB[b]);
  }
}

}  // namespace nilas::sim
