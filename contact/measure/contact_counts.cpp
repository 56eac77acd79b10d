#include "contact/measure/contact_counts.h"

#include <algorithm>
#include <cmath>

#include "contact/law/law_map.h"
#include "contact/measure/measure.h"

namespace nilas::contact {

namespace {

constexpr double k_slip = 10;  // times the residual

struct Counter {
  double least_slip = 0;
  ContactCounts counts;

  void add(double d, double mu, const Vec3& r, const Vec3& u) {
    const double left = std::max(0.0, mu * r.x() - std::hypot(r.y(), r.z()));
    if (u.x() >= d * r.x())
      ++counts.open;
    else if (std::hypot(u.y(), u.z()) > std::max(d * left, least_slip))
      ++counts.sliding;
    else
      ++counts.sticking;
  }
};

}  // namespace

ContactCounts count_contacts(const ContactProblem& problem, const VecX& r, const VecX& u) {
  Counter counter{k_slip * measure(problem, r).law_map_m_s, {}};
  const std::vector<Mat3> diagonal = delassus_diagonal(problem);
  for (int c = 0; c < problem.num_contacts(); ++c) {
    if (problem.is_moment(c)) continue;
    const auto i = static_cast<std::size_t>(c);
    const Vec3 r_c = r.segment<3>(3 * c);
    counter.add(diagonal[i].trace() / 3, problem.mu[i], r_c, compliant_velocity(problem, c, r_c, u.segment<3>(3 * c)));
  }
  return counter.counts;
}

ContactCounts count_contacts(const LocalProblem& problem, const VecX& r, const VecX& u) {
  Counter counter{k_slip * measure(problem, r).law_map_m_s, {}};
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const Vec3 r_c = r.segment<3>(3 * c);
    counter.add(problem.diagonal(c).trace() / 3, problem.mu[c], r_c,
                compliant_velocity(problem, c, r_c, u.segment<3>(3 * c)));
  }
  return counter.counts;
}

}  // namespace nilas::contact
