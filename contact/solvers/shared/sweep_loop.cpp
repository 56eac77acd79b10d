#include "contact/solvers/shared/sweep_loop.h"

#include <cmath>

#include "contact/law/law_map.h"
#include "contact/problem/row_of.h"

namespace nilas::solvers {

/// `measure` finds the same law_map up to rounding: velocities of bodies are summed in another order there.
constexpr double k_agreed_share = 1 - 1e-12;

RowSweeps::RowSweeps(const RowIsland& whole) : rows_(whole.rows), island_(whole.island), residual_(whole.residual) {}

double RowSweeps::law_map() const { return residual_.law_map(rows_, island_) / k_agreed_share; }

VecX RowSweeps::impulses() const {
  VecX r(contact::row_of(island_.last - island_.first));
  for (int k = island_.first; k < island_.last; ++k)
    std::copy_n(rows_.contacts[k].r, 3, r.data() + 3 * (k - island_.first));
  return r;
}

void RowSweeps::set_impulses(const VecX& r) {
  for (int k = island_.first; k < island_.last; ++k)
    std::copy_n(r.data() + 3 * (k - island_.first), 3, rows_.contacts[k].r);
}

LocalSweeps::LocalSweeps(const contact::LocalProblem& problem, const VecX& guess)
    : problem_(problem), r_(guess.size() > 0 ? guess : VecX(VecX::Zero(problem.q.size()))) {
  for (int c = 0; c < problem.num_contacts(); ++c) scales_.push_back(contact::contact_scale(problem, c));
}

double LocalSweeps::law_map() const {
  const VecX u = contact::contact_velocities(problem_, r_);
  double worst = 0;
  for (int c = 0; c < problem_.num_contacts(); ++c) {
    const auto i = static_cast<std::size_t>(c);
    const Vec3 r = r_.segment<3>(contact::row_of(c));
    const Vec3 own = contact::compliant_velocity(problem_, c, r, u.segment<3>(contact::row_of(c)));
    const double map = nilas::contact::law_map(problem_.law, problem_.facets, scales_[i], r, own);
    if (!(map <= worst)) worst = map;
    if (std::isnan(worst)) break;
  }
  return worst;
}

Vec3 LocalSweeps::velocity(int c) const {
  const auto i = static_cast<std::size_t>(c);
  const double* const r = r_.data();
  double u[3] = {0, 0, 0};
  for (int k = problem_.row_start[i]; k < problem_.row_start[i + 1]; ++k) {
    const double* const w = problem_.block[k].data();
    const double* const x = r + 3 * static_cast<std::ptrdiff_t>(problem_.column[k]);
    for (int j = 0; j < 3; ++j) u[j] += w[j] * x[0] + w[j + 3] * x[1] + w[j + 6] * x[2];
  }
  const auto q = problem_.q.segment<3>(contact::row_of(c));
  return {u[0] + q[0], u[1] + q[1], u[2] + q[2]};
}

}  // namespace nilas::solvers
