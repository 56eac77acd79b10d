#include "contact/law/law_map.h"

#include <algorithm>
#include <cmath>

#include "contact/law/cone.h"

namespace nilas::contact {

ContactScale contact_scale(const ContactProblem& problem, int c, double d) {
  const auto i = static_cast<std::size_t>(c);
  // Between two immovable sides compliance is the only way to yield.
  return {problem.mu[i], problem.force_limit[i], d > 0 ? d : problem.compliance[i]};
}

ContactScale contact_scale(const LocalProblem& problem, int c) {
  const auto i = static_cast<std::size_t>(c);
  const double d = problem.diagonal(c).trace() / 3;
  return {problem.mu[i], problem.force_limit[i], d > 0 ? d : problem.compliance[i]};
}

static double immovable_map(const ContactScale& scale, const Vec3& r, const Vec3& u) {
  const double expected = u[0] < 0 ? scale.force_limit : 0;
  return std::isfinite(expected) && r[0] == expected ? 0 : std::abs(u[0]);
}

/// Speed above which an impulse that would move its contact hides u, the velocity of the law, in rounding [m/s].
constexpr double k_largest_speed = 1e12;

/// Returns `map`, or d |r| where the impulse is beyond any answer, so that a diverging iteration never counts as
/// solved.
static double unless_beyond(const ContactScale& scale, const Vec3& r, double map) {
  const double speed = scale.d * r.cwiseAbs().maxCoeff();
  return speed > k_largest_speed ? speed : map;
}

static Vec3 cone_residual(const ContactScale& scale, const Vec3& r, const Vec3& u_hat) {
  return r - project_cone(r - u_hat / scale.d, scale.mu, scale.force_limit);
}

static Vec3 coulomb_residual(const ContactScale& scale, const Vec3& r, const Vec3& u) {
  return cone_residual(scale, r, {u[0] + scale.mu * tangential_norm(u), u[1], u[2]});
}

double ccp_map(const ContactScale& scale, const Vec3& r, const Vec3& u) {
  return scale.d == 0 ? immovable_map(scale, r, u)
                      : unless_beyond(scale, r, scale.d * cone_residual(scale, r, u).norm());
}

double natural_map(const ContactScale& scale, const Vec3& r, const Vec3& u) {
  return scale.d == 0 ? immovable_map(scale, r, u)
                      : unless_beyond(scale, r, scale.d * coulomb_residual(scale, r, u).norm());
}

static Vec3 pyramid_k_residual(int facets, const ContactScale& scale, const Vec3& r, const Vec3& u) {
  const Vec3 u_hat(u[0] + scale.mu * pyramid_support(-u.tail<2>(), facets), u[1], u[2]);
  return r - project_pyramid(r - u_hat / scale.d, scale.mu, facets, scale.force_limit);
}

static double normal_residual(const ContactScale& scale, const Vec3& r, const Vec3& u) {
  return r[0] - std::min(std::max(r[0] - u[0] / scale.d, 0.0), scale.force_limit);
}

static Vec3 box_residual(const ContactScale& scale, const Vec3& r, const Vec3& u) {
  const double bound = scale.mu * std::max(r[0], 0.0);
  Vec3 residual(normal_residual(scale, r, u), 0, 0);
  for (int i = 1; i < 3; ++i) residual[i] = r[i] - std::clamp(r[i] - u[i] / scale.d, -bound, bound);
  return residual;
}

Vec3 natural_residual(const ContactScale& scale, const Vec3& r, const Vec3& u) {
  return scale.d == 0 ? Vec3::Zero() : coulomb_residual(scale, r, u);
}

Vec3 law_residual(Law law, int facets, const ContactScale& scale, const Vec3& r, const Vec3& u) {
  if (scale.d == 0) return Vec3::Zero();
  switch (law) {
    case Law::coulomb:
      return coulomb_residual(scale, r, u);
    case Law::ccp:
      return cone_residual(scale, r, u);
    case Law::pyramid:
      return box_residual(scale, r, u);
    case Law::pyramid_k:
      return pyramid_k_residual(facets, scale, r, u);
    case Law::frictionless:
      return {normal_residual(scale, r, u), 0, 0};
  }
  return Vec3::Zero();
}

double law_map(Law law, int facets, const ContactScale& scale, const Vec3& r, const Vec3& u) {
  if (scale.d == 0) return immovable_map(scale, r, u);
  if (law == Law::frictionless) return unless_beyond(scale, r, scale.d * std::abs(normal_residual(scale, r, u)));
  return unless_beyond(scale, r, scale.d * law_residual(law, facets, scale, r, u).norm());
}

}  // namespace nilas::contact
