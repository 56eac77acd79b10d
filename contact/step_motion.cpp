#include "contact/step_motion.h"

#include "core/base/order_free_sum.h"

namespace nilas::contact {

Vec3 relative_velocity(const StepMotion& motion, const Velocities& velocities, std::size_t contact) {
  const detect::ContactPoint& c = motion.points[contact];
  const auto a = static_cast<std::size_t>(c.a), b = static_cast<std::size_t>(c.b);
  return velocities.v[b] + velocities.w[b].cross(c.p - motion.p[b]) - velocities.v[a] -
         velocities.w[a].cross(c.p - motion.p[a]);
}

std::vector<detect::ContactPoint> carried_points(const StepMotion& motion, const bodies::Bodies& bodies) {
  std::vector<detect::ContactPoint> points = motion.points;
  for (detect::ContactPoint& c : points) {
    const auto turned = [&](int body, const Vec3& x) -> Vec3 {
      const auto b = static_cast<std::size_t>(body);
      return bodies.R_GB[b] * (motion.R[b].transpose() * x);
    };
    const auto carried = [&](int body, const Vec3& x) -> Vec3 {
      const auto b = static_cast<std::size_t>(body);
      return bodies.p_GB[b] + turned(body, x - motion.p[b]);
    };
    const Vec3 on_a = carried(c.a, c.p - 0.5 * c.gap * c.n), on_b = carried(c.b, c.p + 0.5 * c.gap * c.n);
    c.n = (turned(c.a, c.n) + turned(c.b, c.n)).normalized();
    c.p = 0.5 * (on_a + on_b);
    c.gap = c.n.dot(on_b - on_a);
  }
  return points;
}

Wrench contact_impulse_on(const StepMotion& motion, int body) {
  OrderFreeVectorSum force, torque;
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    const detect::ContactPoint& c = motion.points[i];
    if (c.a != body && c.b != body) continue;
    const double sign = c.b == body ? 1 : -1;
    const Vec3 impulse = sign * motion.impulses[i];
    force.add(impulse);
    torque.add((c.p - motion.p[body]).cross(impulse));
    if (!motion.couples.empty()) torque.add(sign * motion.couples[i]);
  }
  return {force.value(), torque.value()};
}

}  // namespace nilas::contact
