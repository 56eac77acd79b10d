#include "core/sim/load_residual.h"

#include <algorithm>

namespace nilas {

static Wrench on_vessel(const ContactPoint& c, const Vec3& com, bool is_b, const Vec3& impulse_on_b) {
  const Vec3 impulse = (is_b ? 1 : -1) * impulse_on_b;
  return {impulse, (c.p - com).cross(impulse)};
}

LoadResidual load_residual(const SolvedProblem& solved, const std::vector<Mat3>& C, const StepMotion& motion,
                           int vessel, int num_parts) {
  LoadResidual sum;
  const Vec3& com = motion.p[static_cast<std::size_t>(vessel)];
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    const ContactPoint& c = motion.points[i];
    const auto is_vessel = [&](int body) { return body >= vessel && body <= vessel + num_parts; };
    const bool is_b = is_vessel(c.b);
    if (is_vessel(c.a) == is_b) continue;
    const ImpulseResidual e = impulse_residual(solved.problem, static_cast<int>(i), solved.d[i], solved.solution.r,
                                               solved.solution.v, std::max(c.gap, 0.0) / motion.h);
    const Wrench of_law = on_vessel(c, com, is_b, C[i] * e.law);
    sum.solver += {of_law.force.cwiseAbs(), of_law.torque.cwiseAbs()};
    if (solved.problem.law != Law::coulomb) sum.law += on_vessel(c, com, is_b, C[i] * (e.coulomb - e.law));
  }
  return sum;
}

}  // namespace nilas
