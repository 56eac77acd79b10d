/// Tests of extragradient and accelerated projected gradient, with brute force as the reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/solvers/apgd.h"
#include "contact/solvers/eg.h"
#include "contact/solvers/enumerate.h"
#include "contact/solvers/nsgs.h"
#include "core/base/error.h"
#include "tests/support/problems/problem_changes.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::solvers {
namespace descent_test {

constexpr double k_gravity = 9.81;
constexpr double k_step = 0.01;
const contact::SolverSettings k_exact{.tolerance = 1e-10, .max_iterations = 100000};

std::vector<std::unique_ptr<ContactSolver>> both(const contact::SolverSettings& shared) {
  std::vector<std::unique_ptr<ContactSolver>> solvers;
  solvers.push_back(std::make_unique<EgSolver>(EgSettings{.shared = shared}));
  solvers.push_back(std::make_unique<ApgdSolver>(ApgdSettings{.shared = shared}));
  return solvers;
}

TEST(Descent, ReachesEveryLawInBothForms) {
  for (const auto& solver : both(k_exact))
    for (const Law law : {Law::coulomb, Law::ccp, Law::pyramid_k, Law::frictionless})
      for (std::uint64_t seed = 0; seed < 5; ++seed) {
        contact::ContactProblem problem = test::random_heap(seed, 8, 14, 0.3);
        problem.law = law;
        const contact::ContactSolution global = solver->solve(problem, {}),
                                       local = solver->solve(contact::reduce(problem), {});
        EXPECT_EQ(global.status, contact::SolveStatus::converged) << solver->name() << seed;
        EXPECT_EQ(local.status, contact::SolveStatus::converged) << solver->name() << seed;
        EXPECT_LE(contact::measure(problem, global.r, global.v).law_map_m_s, 1e-10);
        EXPECT_LT((global.v - contact::velocities(problem, local.r)).cwiseAbs().maxCoeff(), 1e-8);
      }
}

TEST(Descent, AgreesWithGaussSeidel) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    contact::ContactProblem problem = test::random_heap(seed, 8, 14, 0.2);
    problem.law = Law::coulomb;
    const VecX v = NsgsSolver({.shared = k_exact}).solve(problem, {}).v;
    for (const auto& solver : both(k_exact))
      EXPECT_LT((solver->solve(problem, {}).v - v).cwiseAbs().maxCoeff(), 1e-8) << solver->name() << seed;
  }
}

TEST(Descent, AccelerationCarriesAColumnThatSweepsDoNot) {
  // 40 equal bodies: Gauss-Seidel needs 0.93 n^2 sweeps per decade
  contact::ContactProblem problem = test::column(std::vector<double>(40, 2.0), k_step, k_gravity);
  problem.law = Law::coulomb;
  const contact::ContactSolution s = ApgdSolver({.shared = k_exact}).solve(problem, {});
  EXPECT_EQ(s.status, contact::SolveStatus::converged);
  EXPECT_LT(s.iterations, 2000);
  for (int c = 0; c < 40; ++c) EXPECT_NEAR(s.r[3 * c], 2 * (40 - c) * k_gravity * k_step, 1e-6);
}

TEST(Descent, SmallFrictionTakesFewOuterRounds) {
  contact::ContactProblem problem = test::raft(5, 0.1, 0.8, 2);
  problem.law = Law::ccp;
  const int convex = ApgdSolver({.shared = k_exact}).solve(problem, {}).iterations;
  problem.law = Law::coulomb;
  EXPECT_LT(ApgdSolver({.shared = k_exact}).solve(problem, {}).iterations, 15 * convex);
}

TEST(Descent, EndsAtItsLimitWithTheBestThatItMeasured) {
  contact::ContactProblem problem = test::column({1.0, 1e7}, k_step, k_gravity);
  problem.law = Law::coulomb;
  for (const auto& solver : both({.tolerance = 1e-14, .max_iterations = 60, .keep_history = true})) {
    const contact::ContactSolution s = solver->solve(problem, {});
    EXPECT_EQ(s.status, contact::SolveStatus::iteration_limit) << solver->name();
    ASSERT_EQ(s.history.size(), 60u) << solver->name();
    const double left = contact::measure(problem, s.r).law_map_m_s;
    EXPECT_LT(left, 0.7 * k_gravity * k_step) << solver->name();
    // The residual oscillates: the last one is not the least.
    EXPECT_LT(left, 0.99 * s.history.back()) << solver->name();
    double nearest = HUGE_VAL;
    for (const double residual : s.history) nearest = std::min(nearest, std::abs(residual - left));
    EXPECT_LT(nearest, 1e-13) << solver->name();
  }
}

TEST(Descent, StallsWhereDoublesEnd) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    contact::ContactProblem problem = test::random_heap(seed, 8, 14, 0.3);
    problem.law = Law::coulomb;
    for (const auto& solver : both({.tolerance = 1e-30, .max_iterations = 1000000})) {
      const contact::ContactSolution s = solver->solve(problem, {});
      EXPECT_EQ(s.status, contact::SolveStatus::stalled) << solver->name() << seed;
      EXPECT_LT(s.iterations, 100000) << solver->name() << seed;
      EXPECT_LT(contact::measure(problem, s.r).law_map_m_s, 1e-13) << solver->name() << seed;
    }
  }
}

TEST(Descent, AccelerationLiftsWhatExtragradientCannot) {
  const double heavy = 1e7;
  contact::ContactProblem problem = test::column({1.0, heavy}, k_step, k_gravity);
  problem.law = Law::coulomb;
  const contact::SolverSettings shared{.tolerance = 1e-9, .max_iterations = 1000000};
  const contact::ContactSolution slow = EgSolver({.shared = shared}).solve(problem, {});
  EXPECT_EQ(slow.status, contact::SolveStatus::stalled);
  EXPECT_GT(contact::measure(problem, slow.r).law_map_m_s, 0.1 * k_gravity * k_step);
  const contact::ContactSolution quick = ApgdSolver({.shared = shared}).solve(problem, {});
  EXPECT_EQ(quick.status, contact::SolveStatus::converged);
  // |u| <= tolerance at both contacts leaves the upper body at most twice that
  const double share = 2 * shared.tolerance / (k_gravity * k_step);
  EXPECT_NEAR(quick.r[0] / ((heavy + 1) * k_gravity * k_step), 1, share);
  EXPECT_NEAR(quick.r[3] / (heavy * k_gravity * k_step), 1, share);
}

TEST(Descent, AWarmStartFromTheAnswerIsDoneAtOnce) {
  contact::ContactProblem problem = test::raft(5, 0.3, 0.8, 2);
  problem.law = Law::coulomb;
  for (const auto& solver : both({.tolerance = 1e-8, .max_iterations = 20000})) {
    const contact::ContactSolution cold = solver->solve(problem, {});
    EXPECT_EQ(cold.status, contact::SolveStatus::converged);
    EXPECT_EQ(solver->solve(problem, cold.r).iterations, 0) << solver->name();
  }
}

TEST(Descent, RefusesTheBoxPyramid) {
  contact::ContactProblem problem = test::random_heap(1, 3, 3, 0.3);
  problem.law = Law::pyramid;
  for (const auto& solver : both(k_exact)) EXPECT_THROW(solver->solve(problem, {}), InputError);
  EXPECT_THROW(EnumerateSolver({.shared = k_exact}).solve(problem, {}), InputError);
}

TEST(Descent, SidesThatCannotMove) {
  contact::ContactProblem problem = test::random_heap(3, 4, 5, 0.4);
  problem.law = Law::coulomb;
  problem.add_contact(-1, MatX(3, 0), -1, MatX(3, 0), 77);
  problem.w[15] = -1;
  for (const auto& solver : both(k_exact)) {
    EXPECT_NE(solver->solve(problem, {}).message.find("key 77"), std::string::npos);
    contact::ContactProblem limited = problem;
    limited.force_limit.back() = 2;
    EXPECT_EQ(solver->solve(limited, {}).r[15], 2);
    EXPECT_EQ(solver->solve(limited, {}).status, contact::SolveStatus::converged);
  }
}

TEST(Enumerate, ConfirmsTheOthers) {
  for (std::uint64_t seed = 0; seed < 6; ++seed)
    for (const Law law : {Law::coulomb, Law::ccp, Law::frictionless}) {
      contact::ContactProblem problem = test::random_heap(50 + seed, 4, 5, 0.3);
      problem.law = law;
      const contact::ContactSolution s = EnumerateSolver({.shared = k_exact}).solve(problem, {});
      ASSERT_EQ(s.status, contact::SolveStatus::converged) << seed << contact::to_string(s.status);
      EXPECT_LT((s.v - NsgsSolver({.shared = k_exact}).solve(problem, {}).v).cwiseAbs().maxCoeff(), 1e-8) << seed;
    }
}

TEST(Enumerate, SaysWhenThereAreTooMany) {
  contact::ContactProblem problem = test::raft(4, 0.3, 1.0, 4);
  problem.law = Law::coulomb;
  const contact::ContactSolution s = EnumerateSolver({.shared = k_exact}).solve(problem, {});
  EXPECT_EQ(s.status, contact::SolveStatus::numerical_error);
  EXPECT_NE(s.message.find("up to 8 contacts"), std::string::npos);
}

}  // namespace descent_test
}  // namespace nilas::solvers
