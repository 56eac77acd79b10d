#include "contact/solvers/shared/mass_scaled.h"

#include <algorithm>
#include <cmath>

#include "contact/law/cone.h"
#include "contact/problem/row_of.h"

namespace nilas::solvers {

namespace {

/// Larger differences between W' and its symmetric part, whose mean diagonal is 1, are not rounding.
constexpr double k_skew = 1e-14;

}  // namespace

MassScaled mass_scaled(const contact::LocalProblem& island) {
  MassScaled scaled;
  scaled.law = island.law;
  const int nc = island.num_contacts();
  scaled.w = contact::sparse_matrix(island);
  scaled.q = island.q;
  VecX rows(3 * nc);
  for (int a = 0; a < nc; ++a) {
    const auto first = contact::row_of(a);
    const double normal = island.compliance[a], tangential = island.tangential_compliance[a];
    scaled.w.coeffRef(first, first) += normal;
    if (tangential > 0)
      for (const auto row : {first + 1, first + 2}) scaled.w.coeffRef(row, row) += tangential;
    const double d = (island.diagonal(a).trace() + normal + 2 * tangential) / 3;
    const double e = 1 / std::sqrt(d);
    scaled.scale.push_back(e);
    rows.segment<3>(contact::row_of(a)).setConstant(e);
    scaled.mu.push_back(island.law == Law::frictionless ? 0 : island.mu[a]);
    scaled.cap.push_back(island.force_limit[a] / e);
  }
  scaled.w = rows.asDiagonal() * scaled.w * rows.asDiagonal();
  scaled.q = scaled.q.cwiseProduct(rows);
  const Eigen::SparseMatrix<double> transposed = scaled.w.transpose();
  scaled.symmetric = 0.5 * (scaled.w + transposed);
  scaled.skew = Eigen::SparseMatrix<double>(scaled.w - scaled.symmetric).coeffs().cwiseAbs().maxCoeff() > k_skew;
  return scaled;
}

VecX MassScaled::impulses(const VecX& scaled) const {
  VecX r = scaled;
  for (int a = 0; a < num_contacts(); ++a) r.segment<3>(contact::row_of(a)) *= scale[a];
  return r;
}

VecX MassScaled::scaled_impulses(const VecX& r) const {
  VecX scaled = r;
  for (int a = 0; a < num_contacts(); ++a) scaled.segment<3>(contact::row_of(a)) /= scale[a];
  return scaled;
}

double convex_map(const MassScaled& problem, const VecX& scaled, const VecX& velocity) {
  double worst = 0;
  for (int a = 0; a < problem.num_contacts(); ++a) {
    const Vec3 r = scaled.segment<3>(contact::row_of(a));
    const Vec3 step = r - velocity.segment<3>(contact::row_of(a));
    const double map = (r - contact::project_cone(step, problem.mu[a], problem.cap[a])).norm() / problem.scale[a];
    if (!(map <= worst)) worst = map;  // a NaN stays
  }
  return worst;
}

VecX de_saxce_shift(const MassScaled& problem, const VecX& velocity) {
  VecX shift = VecX::Zero(velocity.size());
  for (int a = 0; a < problem.num_contacts(); ++a)
    shift[contact::row_of(a)] = problem.mu[a] * contact::tangential_norm(velocity.segment<3>(contact::row_of(a)));
  return shift;
}

std::optional<contact::ContactSolution> solve_immovable(const contact::LocalProblem& island) {
  const int nc = island.num_contacts();
  contact::ContactSolution solution;
  solution.r = VecX::Zero(3 * nc);
  bool any = false, all = true;
  for (int a = 0; a < nc; ++a) {
    if (island.diagonal(a).trace() + island.compliance[a] > 0) {
      all = false;
      continue;
    }
    any = true;
    if (!(island.q[contact::row_of(a)] < 0)) continue;
    if (std::isfinite(island.force_limit[a])) {
      solution.r[contact::row_of(a)] = island.force_limit[a];
    } else {
      solution.message = "contact " + std::to_string(island.key[a]) + " closes and neither side can move";
    }
  }
  if (!any) return std::nullopt;
  if (!all && solution.message.empty()) solution.message = "W has coupled rows with a zero diagonal block";
  solution.status = solution.message.empty() ? contact::SolveStatus::converged : contact::SolveStatus::numerical_error;
  return solution;
}

}  // namespace nilas::solvers
