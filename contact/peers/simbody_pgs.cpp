#include "contact/peers/simbody_pgs.h"

#include <algorithm>
#include <cmath>

#include "core/vessel/tree/simbody.h"

namespace nilas::contact {

namespace {

/// A dense W of more takes over 72 MB.
constexpr int k_most_contacts = 1000;
/// Smallest change of the iterate on which the solver can stop; below it the change is rounding.
constexpr double k_least_change = 1e-15;

SimTK::Matrix dense_operator(const LocalProblem& island) {
  const int rows = 3 * island.num_contacts();
  SimTK::Matrix out(rows, rows, 0.0);
  for (int a = 0; a < island.num_contacts(); ++a)
    for (int k = island.row_start[a]; k < island.row_start[static_cast<std::size_t>(a) + 1]; ++k) {
      const int b = island.column[k];
      const Mat3& block = island.block[k];
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          out(3 * a + i, 3 * b + j) += 0.5 * block(i, j);
          out(3 * b + j, 3 * a + i) += 0.5 * block(i, j);
        }
    }
  return out;
}

ContactSolution refused(const LocalProblem& island, const std::string& why) {
  ContactSolution out;
  out.r = VecX::Zero(island.q.size());
  out.message = why;
  return out;
}

}  // namespace

void SimbodyPgsSolver::demand_law(Law law) const {
  solvers::demand_known("simbody-pgs", std::array{Law::coulomb}, law);
}

ContactSolution SimbodyPgsSolver::solve_island(const LocalProblem& island, const VecX&, const SolverSettings& shared,
                                               const solvers::Budget& budget) const {
  const int nc = island.num_contacts(), rows = 3 * nc;
  if (nc > k_most_contacts) return refused(island, "simbody-pgs takes at most 1000 contacts of one island");
  if (std::any_of(island.force_limit.begin(), island.force_limit.end(), [](double x) { return std::isfinite(x); }))
    return refused(island, "simbody-pgs knows no force limit");

  const SimTK::Matrix A = dense_operator(island);
  SimTK::Vector D(rows, 0.0), expand(rows, 0.0), start(rows), applied(rows, 0.0), pi(rows, 0.0);
  SimTK::Array_<SimTK::MultiplierIndex> participating, expanding;
  SimTK::Array_<SimTK::ImpulseSolver::UniContactRT> contacts;
  for (int c = 0; c < nc; ++c) {
    SimTK::ImpulseSolver::UniContactRT contact;
    contact.m_ucx = SimTK::UnilateralContactIndex(c);
    contact.m_Nk = SimTK::MultiplierIndex(3 * c);
    for (int i = 1; i < 3; ++i) contact.m_Fk.push_back(SimTK::MultiplierIndex(3 * c + i));
    contact.m_type = SimTK::ImpulseSolver::Participating;
    contact.m_slipVel = SimTK::Vec2(0);
    contact.m_slipMag = 0;
    contact.m_effMu = island.mu[c];
    contacts.push_back(contact);
    D[3 * c] = island.compliance[c];
    for (int i = 1; i < 3; ++i) D[3 * c + i] = island.tangential_compliance[c];
    for (int i = 0; i < 3; ++i) {
      participating.push_back(SimTK::MultiplierIndex(3 * c + i));
      start[3 * c + i] = island.q[3 * c + i];
    }
  }
  SimTK::Array_<SimTK::ImpulseSolver::UncondRT> unconditional;
  SimTK::Array_<SimTK::ImpulseSolver::UniSpeedRT> speeds;
  SimTK::Array_<SimTK::ImpulseSolver::BoundedRT> bounded;
  SimTK::Array_<SimTK::ImpulseSolver::ConstraintLtdFrictionRT> joint_friction;
  SimTK::Array_<SimTK::ImpulseSolver::StateLtdFrictionRT> state_friction;
  SimTK::PGSImpulseSolver solver(0);
  solver.setConvergenceTol(std::max(1e-3 * shared.tolerance, k_least_change));
  solver.setMaxIterations(budget.iterations());
  solver.solve(0, participating, A, D, expanding, expand, start, applied, pi, unconditional, contacts, speeds, bounded,
               joint_friction, state_friction);

  ContactSolution out;
  out.iterations = budget.iterations();
  out.r.resize(rows);
  for (int i = 0; i < rows; ++i) out.r[i] = -pi[i];
  if (!out.r.allFinite()) return refused(island, "simbody-pgs returned impulses that are not finite");
  out.status =
      measure(island, out.r).law_map_m_s <= shared.tolerance ? SolveStatus::converged : SolveStatus::iteration_limit;
  return out;
}

}  // namespace nilas::contact
