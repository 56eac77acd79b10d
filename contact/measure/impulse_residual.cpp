#include "contact/measure/impulse_residual.h"

#include <algorithm>

#include "contact/law/cone.h"
#include "contact/law/law_map.h"
#include "contact/law/moment_cone.h"
#include "contact/problem/operators.h"
#include "contact/problem/row_of.h"

namespace nilas::contact {

static Vec3 without_hover(Law law, double mu, double gap_speed, const Vec3& u) {
  if (law != Law::ccp) return u;
  return {u[0] - std::clamp(gap_speed, 0.0, mu * tangential_norm(u)), u[1], u[2]};
}

ImpulseResidual impulse_residual(const ContactProblem& problem, int c, double d, const VecX& r, const VecX& v,
                                 double gap_speed) {
  const auto segment = [&](int i) -> Vec3 { return r.segment<3>(row_of(i)); };
  const ContactScale scale = contact_scale(problem, c, d);
  const Vec3 r_c = segment(c);
  const Vec3 u = compliant_velocity(problem, c, r_c, contact_velocity(problem, c, v.data()));
  const Vec3 closed = without_hover(problem.law, scale.mu, gap_speed, u);
  const int m = problem.moment_of(c);
  if (m < 0) {
    const Vec3 law = law_residual(problem.law, problem.facets, scale, r_c, u);
    return {law, problem.law == Law::coulomb ? law : natural_residual(scale, r_c, closed)};
  }
  const ForceAndMoment r_all{r_c, segment(m)};
  const Vec3 u_moment = contact_velocity(problem, m, v.data());
  return {law_residual(problem.law, scale, r_all, {u, u_moment}), natural_residual(scale, r_all, {closed, u_moment})};
}

}  // namespace nilas::contact
