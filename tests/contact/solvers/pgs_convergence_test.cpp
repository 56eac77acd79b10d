/// Rates, stops and tolerances.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/solvers/pgs.h"
#include "tests/contact/solvers/contraction.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::solvers {
namespace pgs_convergence_test {

constexpr double k_gravity = 9.81;
constexpr double k_step = 0.01;

/// Contraction of law_map per sweep, late in the history of a column's impulses from rest.
double measured_rate(const std::vector<double>& masses, int sweeps) {
  const contact::ContactProblem problem = test::column(masses, k_step, k_gravity);
  const PgsSolver solver({.shared = {.tolerance = 0, .max_iterations = sweeps, .keep_history = true}});
  const contact::ContactSolution s = solver.solve(problem, {});
  EXPECT_EQ(s.history.size(), static_cast<std::size_t>(sweeps));
  return test::late_contraction(s.history);
}

TEST(PgsConvergence, EqualColumnContractsAsTheTextbookSays) {
  for (const auto& [n, sweeps] : std::vector<std::pair<int, int>>{{5, 200}, {10, 600}, {50, 12000}}) {
    const double expected = std::pow(std::cos(k_pi / (2 * n)), 2);
    EXPECT_NEAR(measured_rate(std::vector<double>(static_cast<std::size_t>(n), 3.0), sweeps), expected,
                1e-3 * expected);
    EXPECT_NEAR(
        std::log(measured_rate(std::vector<double>(static_cast<std::size_t>(n), 3.0), sweeps)) / std::log(expected), 1,
        1e-2);
  }
}

TEST(PgsConvergence, HeavyOnLightContractsAsTheTextbookSays) {
  for (const double ratio : {1.0, 10.0, 100.0}) {
    const double expected = ratio / (ratio + 1);
    EXPECT_NEAR(1 - measured_rate({2.0, 2.0 * ratio}, static_cast<int>(20 * (ratio + 1))), 1 - expected,
                1e-3 * (1 - expected));
  }
}

TEST(PgsConvergence, ColumnCarriesItsWeight) {
  const std::vector<double> masses{1, 2, 3, 4};
  const contact::ContactProblem problem = test::column(masses, k_step, k_gravity);
  const contact::ContactSolution s =
      PgsSolver({.shared = {.tolerance = 1e-13, .max_iterations = 10000}}).solve(problem, {});
  EXPECT_EQ(s.status, contact::SolveStatus::converged);
  double above = 10;
  for (int c = 0; c < 4; ++c) {
    EXPECT_NEAR(s.r[3 * c], above * k_gravity * k_step, 1e-11);
    above -= masses[c];
  }
}

TEST(PgsConvergence, DiscReachesExactCoulomb) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    contact::ContactProblem problem = test::random_heap(seed, 8, 14, 0.3);
    problem.law = Law::coulomb;
    const contact::ContactSolution s =
        PgsSolver({.shared = {.tolerance = 1e-10, .max_iterations = 200000}}).solve(problem, {});
    EXPECT_EQ(s.status, contact::SolveStatus::converged) << seed;
    const contact::Residuals m = contact::measure(problem, s.r, s.v);
    EXPECT_LE(m.natural_map_m_s, 1e-10) << seed;
    EXPECT_LT(m.momentum_sqrtJ, 1e-12) << seed;
    EXPECT_LT((s.u - contact::contact_velocities(problem, s.v)).norm(), 1e-15);
  }
}

TEST(PgsConvergence, PyramidReachesItsOwnLawAndNotTheCone) {
  double farthest = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    contact::ContactProblem problem = test::random_heap(seed, 8, 14, 0.3);
    problem.law = Law::pyramid;
    const contact::ContactSolution s =
        PgsSolver({.shared = {.tolerance = 1e-10, .max_iterations = 200000}}).solve(problem, {});
    EXPECT_EQ(s.status, contact::SolveStatus::converged) << seed;
    const contact::Residuals m = contact::measure(problem, s.r, s.v);
    EXPECT_LE(m.law_map_m_s, 1e-10) << seed;
    farthest = std::max(farthest, m.natural_map_m_s);
  }
  EXPECT_GT(farthest, 0.01);
}

TEST(PgsConvergence, ConvergedMeansWhatMeasureSays) {
  for (const Law law : {Law::pyramid, Law::coulomb, Law::frictionless})
    for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
      contact::ContactProblem problem = test::raft(8, 0.3, 0.8, 4);
      problem.law = law;
      const contact::ContactSolution s =
          PgsSolver({.shared = {.tolerance = tolerance, .max_iterations = 100000}}).solve(problem, {});
      EXPECT_EQ(s.status, contact::SolveStatus::converged);
      EXPECT_LE(contact::measure(problem, s.r).law_map_m_s, tolerance);
    }
}

TEST(PgsConvergence, StopsSoonAfterTheToleranceHolds) {
  contact::ContactProblem problem = test::raft(8, 0.3, 0.8, 4);
  problem.law = Law::pyramid;
  const contact::SolverSettings shared{.tolerance = 1e-6, .max_iterations = 100000, .keep_history = true};
  const contact::ContactSolution s = PgsSolver({.shared = shared}).solve(problem, {});
  ASSERT_EQ(s.history.size(), static_cast<std::size_t>(s.iterations));
  int first = 0;
  while (s.history[first] > shared.tolerance) ++first;
  EXPECT_LE(s.iterations, first + 1 + s.iterations / 10);
}

TEST(PgsConvergence, AHistoryDoesNotChangeTheAnswer) {
  const contact::ContactProblem problem = test::random_heap(3, 8, 14, 0.3);
  contact::SolverSettings shared{.tolerance = 1e-8, .max_iterations = 100000};
  const contact::ContactSolution plain = PgsSolver({.shared = shared}).solve(problem, {});
  shared.keep_history = true;
  const contact::ContactSolution watched = PgsSolver({.shared = shared}).solve(problem, {});
  EXPECT_EQ(plain.r, watched.r);
  EXPECT_TRUE(plain.history.empty());
  EXPECT_LE(watched.history.back(), 1e-8);
}

TEST(PgsConvergence, ZeroToleranceDoesExactlyTheSweepsAsked) {
  const contact::ContactProblem problem = test::random_heap(3, 8, 14, 0.3);
  const contact::ContactSolution s = PgsSolver({.shared = {.tolerance = 0, .max_iterations = 37}}).solve(problem, {});
  EXPECT_EQ(s.iterations, 37);
  EXPECT_EQ(s.status, contact::SolveStatus::iteration_limit);
  const contact::ContactSolution none = PgsSolver({.shared = {.tolerance = 0, .max_iterations = 0}}).solve(problem, {});
  EXPECT_EQ(none.iterations, 0);
  EXPECT_EQ(none.r, VecX::Zero(42));
}

TEST(PgsConvergence, TooFewSweepsReachTheIterationLimit) {
  const contact::ContactProblem problem = test::column(std::vector<double>(20, 1.0), k_step, k_gravity);
  const contact::ContactSolution s =
      PgsSolver({.shared = {.tolerance = 1e-8, .max_iterations = 15}}).solve(problem, {});
  EXPECT_EQ(s.status, contact::SolveStatus::iteration_limit);
  EXPECT_EQ(s.iterations, 15);
}

TEST(PgsConvergence, AToleranceBelowRoundingStalls) {
  const contact::ContactProblem problem = test::random_heap(3, 8, 14, 0.3);
  const contact::ContactSolution s =
      PgsSolver({.shared = {.tolerance = 1e-30, .max_iterations = 1000000}}).solve(problem, {});
  EXPECT_EQ(s.status, contact::SolveStatus::stalled);
  EXPECT_LT(s.iterations, 10000);
  EXPECT_LT(contact::measure(problem, s.r).law_map_m_s, 1e-13);
}

TEST(PgsConvergence, WarmStartSavesSweeps) {
  contact::ContactProblem problem = test::raft(8, 0.3, 0.8, 4);
  problem.law = Law::pyramid;
  const PgsSolver solver({.shared = {.tolerance = 1e-8, .max_iterations = 100000}});
  const contact::ContactSolution cold = solver.solve(problem, {});
  EXPECT_GT(cold.iterations, 50);
  const contact::ContactSolution again = solver.solve(problem, cold.r);
  EXPECT_EQ(again.status, contact::SolveStatus::converged);
  EXPECT_LE(again.iterations, 1);
  problem.f *= 1.001;  // The problem is that of the next step of a slow scene.
  EXPECT_LT(solver.solve(problem, cold.r).iterations, solver.solve(problem, {}).iterations);
}

TEST(PgsConvergence, BackwardSweepsCarryAPushDownAChain) {
  // The contacts are listed against the push: a forward sweep transmits it by one contact, a backward sweep by all.
  const int n = 60;
  contact::ContactProblem problem;
  problem.law = Law::frictionless;
  std::vector<test::TestBody> bodies;
  for (int k = 0; k < n; ++k) {
    bodies.push_back({1, Mat3::Identity(), Vec3(k, 0, 0), Vec3(k == 0 ? 1.0 : 0.0, 0, 0), Vec3::Zero()});
    test::add_body(problem, bodies.back());
  }
  for (int k = n - 2; k >= 0; --k)
    test::add_contact(problem, bodies, k, k + 1, Vec3(k + 0.5, 0, 0), test::frame_of(Vec3::UnitX()), 0);
  const auto last_body_speed = [&](bool symmetric) {
    const PgsSolver solver({.shared = {.tolerance = 0, .max_iterations = 4}, .symmetric_sweeps = symmetric});
    return solver.solve(problem, {}).v[6 * (n - 1)];
  };
  EXPECT_EQ(last_body_speed(false), 0);
  EXPECT_GT(last_body_speed(true), 0);
  const auto converged = [&](bool symmetric) {
    const PgsSolver solver({.shared = {.tolerance = 1e-9, .max_iterations = 100000}, .symmetric_sweeps = symmetric});
    return solver.solve(problem, {});
  };
  const contact::ContactSolution s = converged(true);
  EXPECT_EQ(s.status, contact::SolveStatus::converged);
  for (int k = 0; k < n; ++k) EXPECT_NEAR(s.v[6 * k], 1.0 / n, 1e-6);
}

}  // namespace pgs_convergence_test
}  // namespace nilas::solvers
