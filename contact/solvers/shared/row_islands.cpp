#include "contact/solvers/shared/row_islands.h"

#include <algorithm>

#include "contact/problem/operators.h"
#include "contact/problem/row_of.h"
#include "core/base/error.h"
#include "core/base/parallel.h"

namespace nilas::solvers {

namespace {

void fail(const std::string& message, contact::ContactSolution& out) {
  out.status = contact::SolveStatus::numerical_error;
  out.message = message;
}

contact::ContactSolution solve_one(const RowIsland& island, const contact::SolverSettings& shared,
                                   const RowSolve& solve) {
  contact::ContactSolution part = solve(island);
  const auto culprit = island.residual.find_culprit(island.rows, island.island, shared.tolerance);
  if (culprit.contact >= 0)
    fail(closing_message(culprit.contact, island.problem.key[culprit.contact], culprit.closing_speed), part);
  return part;
}

/// The islands' worst: an island that stopped early keeps its last law_map.
void merge(const std::vector<contact::ContactSolution>& parts, contact::ContactSolution& out) {
  out.status = contact::SolveStatus::converged;
  std::size_t longest = 0;
  for (const contact::ContactSolution& part : parts) {
    out.iterations = std::max(out.iterations, part.iterations);
    out.status = contact::worse(out.status, part.status);
    if (out.message.empty()) out.message = part.message;
    longest = std::max(longest, part.history.size());
  }
  out.history.assign(longest, 0.0);
  for (const contact::ContactSolution& part : parts)
    for (std::size_t k = 0; k < longest && !part.history.empty(); ++k)
      out.history[k] = std::max(out.history[k], part.history[std::min(k, part.history.size() - 1)]);
}

void solve_all(const contact::ContactProblem& problem, const contact::MassInverse& masses, PgsRows& rows,
               const contact::SolverSettings& shared, const RowSolve& solve, contact::ContactSolution& out) {
  std::vector<contact::ContactSolution> parts(rows.islands.size());
  RowResidual residual(problem, masses, shared.threads);
  const auto is_large = [&](std::size_t i) { return rows.islands[i].last - rows.islands[i].first >= k_large_island; };
  const auto solve_island = [&](std::size_t i, int threads) {
    parts[i] = solve_one({problem, masses, rows, rows.islands[i], residual, threads}, shared, solve);
  };
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (is_large(i)) solve_island(i, shared.threads);
  parallel_for(static_cast<std::ptrdiff_t>(parts.size()), shared.threads, [&](std::ptrdiff_t k) {
    const auto i = static_cast<std::size_t>(k);
    if (!is_large(i)) solve_island(i, 1);
  });
  for (std::size_t k = 0; k < rows.source.size(); ++k)
    out.r.segment<3>(contact::row_of(rows.source[k])) = Eigen::Map<const Vec3>(rows.contacts[k].r);
  merge(parts, out);
}

}  // namespace

contact::ContactSolution solve_row_islands(const contact::PreparedProblem& prepared, const VecX& guess,
                                           const contact::SolverSettings& shared, RowOrder order,
                                           const RowSolve& solve) {
  const contact::ContactProblem& problem = prepared.problem();
  const contact::MassInverse& masses = prepared.masses();
  NILAS_DEMAND(guess.size() == 0 || guess.size() == 3 * problem.num_contacts());
  PgsRows rows = make_pgs_rows(prepared, guess, order, shared.threads);
  contact::ContactSolution out;
  out.r = VecX::Zero(contact::row_of(problem.num_contacts()));
  if (masses.first_bad_block() >= 0)
    fail("mass block " + std::to_string(masses.first_bad_block()) + " is not positive definite", out);
  else if (!rows.finite || !guess.allFinite())
    fail("the problem or the guess holds numbers that are not finite", out);
  else
    solve_all(problem, masses, rows, shared, solve, out);
  out.v = contact::velocities(prepared, out.r);
  out.u.resize(out.r.size());
  parallel_for(problem.num_contacts(), shared.threads, [&](std::ptrdiff_t c) {
    out.u.segment<3>(3 * c) = contact::contact_velocity(problem, static_cast<int>(c), out.v.data());
  });
  if (out.status != contact::SolveStatus::numerical_error && !(out.v.allFinite() && out.r.allFinite()))
    fail("the impulses grew beyond all numbers", out);
  return out;
}

}  // namespace nilas::solvers
