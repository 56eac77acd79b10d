#include "core/sim/advance.h"

#include <cmath>

#include "core/base/parallel.h"

namespace nilas {

Quat exponential(const Vec3& turn) {
  const double angle = turn.norm();
  constexpr double k_small_angle = 1e-4;  // [rad] below it sin(x/2)/x differs from its series by less than rounding
  const double scale = angle < k_small_angle ? 0.5 - angle * angle / 48.0 : std::sin(0.5 * angle) / angle;
  return {std::cos(0.5 * angle), scale * turn.x(), scale * turn.y(), scale * turn.z()};
}

void free_velocities(const Bodies& bodies, const std::vector<Wrench>& loads, double h, Velocities& out) {
  out.v = bodies.v_GB;
  out.w = bodies.w_GB;
  for (int k = 0; k < bodies.size(); ++k) {
    if (!bodies.is_free(k)) continue;
    const auto b = static_cast<std::size_t>(k);
    out.v[b] += h / bodies.mass[b] * loads[b].force;
    const Mat3& R = bodies.R_GB[b];
    out.w[b] += R * (bodies.inertia_inverse_B[b] * (R.transpose() * (h * loads[b].torque)));
  }
}

static void turn_with_angular_momentum(Bodies& bodies, int k, const Vec3& w, double h) {
  const auto b = static_cast<std::size_t>(k);
  const Mat3& R = bodies.R_GB[b];
  const Vec3 L = R * (bodies.inertia_B[b] * (R.transpose() * w));
  const Quat q = bodies.q_GB[b];
  const auto angular_velocity = [&](const Quat& attitude) -> Vec3 {
    return attitude * (bodies.inertia_inverse_B[b] * (attitude.conjugate() * L));
  };
  Vec3 w_end = w;
  // The mean of both ends is a fixed point; each pass gains a factor of about h |w|.
  constexpr int k_passes = 3;
  Quat q_end = q;
  for (int pass = 0; pass < k_passes; ++pass) {
    q_end = (exponential(0.5 * h * (w + w_end)) * q).normalized();
    w_end = angular_velocity(q_end);
  }
  bodies.w_GB[b] = w_end;
  bodies.q_GB[b] = q_end;
}

void advance(Bodies& bodies, const Velocities& velocities, double h, bool gyroscopic, int threads) {
  parallel_for(bodies.size(), threads, [&](std::ptrdiff_t i) {
    const int k = static_cast<int>(i);
    if (!bodies.is_free(k)) return;
    const auto b = static_cast<std::size_t>(k);
    bodies.v_GB[b] = velocities.v[b];
    const Vec3 w = velocities.w[b];
    if (gyroscopic) {
      turn_with_angular_momentum(bodies, k, w, h);
    } else {
      bodies.w_GB[b] = w;
      bodies.q_GB[b] = exponential(h * w) * bodies.q_GB[b];
    }
    bodies.set_pose(k, bodies.p_GB[b] + h * velocities.v[b], bodies.q_GB[b]);
  });
}

void displace(Bodies& bodies, const Velocities& pseudo, double h) {
  for (int k = 0; k < bodies.size(); ++k) {
    if (!bodies.is_free(k)) continue;
    const auto b = static_cast<std::size_t>(k);
    if (pseudo.v[b].isZero(0) && pseudo.w[b].isZero(0)) continue;
    bodies.set_pose(k, bodies.p_GB[b] + h * pseudo.v[b], exponential(h * pseudo.w[b]) * bodies.q_GB[b]);
  }
}

}  // namespace nilas
