#include "core/sim/account/load_residual.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <vector>

#include "contact/problem/islands.h"
#include "core/base/parallel.h"

namespace nilas::sim {

static Wrench on_vessel(const detect::ContactPoint& c, const Vec3& com, bool is_b, const Vec3& impulse_on_b) {
  const Vec3 impulse = (is_b ? 1 : -1) * impulse_on_b;
  return {impulse, (c.p - com).cross(impulse)};
}

static contact::ImpulseResidual residual_of(const contact::SolvedProblem& solved, const contact::StepMotion& motion,
                                            std::size_t i) {
  return contact::impulse_residual(solved.problem, static_cast<int>(i), solved.d[i], solved.solution.r,
                                   solved.solution.v, std::max(motion.points[i].gap, 0.0) / motion.h);
}

/// The residuals of contacts that reach the vessel only through other bodies. They count in absolute value along every
/// axis, because the direction in which they would reach the vessel is unknown.
static Wrench from_behind(const contact::SolvedProblem& solved, const contact::StepMotion& motion, int vessel,
                          int num_parts, int threads) {
  const auto is_vessel = [&](int body) { return body >= vessel && body <= vessel + num_parts; };
  const auto points = static_cast<int>(motion.points.size());
  const auto of_vessel = [&](int c) { return is_vessel(motion.points[c].a) || is_vessel(motion.points[c].b); };
  std::vector<int> behind;
  for (std::vector<int>& island : contact::find_islands(solved.problem)) {
    std::erase_if(island, [&](int c) { return c >= points; });  // drops the moments
    if (std::any_of(island.begin(), island.end(), of_vessel))
      std::copy_if(island.begin(), island.end(), std::back_inserter(behind), std::not_fn(of_vessel));
  }
  std::vector<double> impulse(behind.size());
  parallel_for(static_cast<std::ptrdiff_t>(behind.size()), threads, [&](std::ptrdiff_t k) {
    impulse[k] = residual_of(solved, motion, static_cast<std::size_t>(behind[k])).law.norm();
  });
  Wrench sum;
  for (std::size_t k = 0; k < behind.size(); ++k) {
    const double arm = (motion.points[behind[k]].p - motion.p[vessel]).norm();
    sum += {Vec3::Constant(impulse[k]), Vec3::Constant(arm * impulse[k])};
  }
  return sum;
}

LoadResidual load_residual(const contact::SolvedProblem& solved, const std::vector<Mat3>& C,
                           const contact::StepMotion& motion, int vessel, int num_parts, int threads) {
  LoadResidual sum;
  const auto is_vessel = [&](int body) { return body >= vessel && body <= vessel + num_parts; };
  const Vec3& com = motion.p[vessel];
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    const detect::ContactPoint& c = motion.points[i];
    const bool is_b = is_vessel(c.b);
    if (is_vessel(c.a) == is_b) continue;
    const contact::ImpulseResidual e = residual_of(solved, motion, i);
    const Wrench of_law = on_vessel(c, com, is_b, C[i] * e.law);
    sum.solver += {of_law.force.cwiseAbs(), of_law.torque.cwiseAbs()};
    if (solved.problem.law != Law::coulomb) sum.law += on_vessel(c, com, is_b, C[i] * (e.coulomb - e.law));
  }
  if (solved.solution.status != contact::SolveStatus::converged)
    sum.solver += from_behind(solved, motion, vessel, num_parts, threads);
  return sum;
}

}  // namespace nilas::sim
