/// Tests of block Gauss-Seidel: rates, stops, limits and forms.
#include "contact/solvers/nsgs.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "tests/contact/solvers/contraction.h"
#include "tests/support/problems/problem_changes.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::solvers {
namespace nsgs_test {

constexpr double k_gravity = 9.81;
constexpr double k_step = 0.01;

contact::ContactSolution solve(const contact::ContactProblem& problem, double tolerance = 1e-10, int most = 200000,
                               int threads = 1) {
  const contact::SolverSettings shared{.tolerance = tolerance, .max_iterations = most, .threads = threads};
  return NsgsSolver({.shared = shared}).solve(problem, {});
}

/// Contraction of law_map per sweep, late in the history.
template <class Problem>
double rate_of(const Problem& problem, int sweeps) {
  const contact::SolverSettings shared{.tolerance = 0, .max_iterations = sweeps, .keep_history = true};
  const contact::ContactSolution s = NsgsSolver({.shared = shared}).solve(problem, {});
  EXPECT_EQ(s.history.size(), static_cast<std::size_t>(sweeps));
  return test::late_contraction(s.history);
}

TEST(Nsgs, EqualColumnContractsAsTheTextbookSays) {
  for (const Law law : {Law::coulomb, Law::ccp, Law::frictionless})
    for (const auto& [n, sweeps] : std::vector<std::pair<int, int>>{{5, 200}, {10, 600}, {20, 2400}}) {
      contact::ContactProblem problem =
          test::column(std::vector<double>(static_cast<std::size_t>(n), 3.0), k_step, k_gravity);
      problem.law = law;
      const double expected = std::pow(std::cos(k_pi / (2 * n)), 2);
      EXPECT_NEAR(rate_of(problem, sweeps), expected, 1e-3 * expected) << n;
      EXPECT_NEAR(std::log(rate_of(contact::reduce(problem), sweeps)) / std::log(expected), 1, 1e-2) << n;
    }
}

TEST(Nsgs, HeavyOnLightContractsAsTheTextbookSays) {
  for (const double ratio : {1.0, 10.0, 100.0}) {
    contact::ContactProblem problem = test::column({2.0, 2.0 * ratio}, k_step, k_gravity);
    problem.law = Law::coulomb;
    for (double& mu : problem.mu) mu = 0.4;
    const double expected = ratio / (ratio + 1);
    EXPECT_NEAR(1 - rate_of(problem, static_cast<int>(20 * (ratio + 1))), 1 - expected, 1e-3 * (1 - expected));
  }
}

TEST(Nsgs, OneContactTakesOneSweep) {
  const contact::ContactProblem problem = test::with_order(test::random_heap(3, 4, 6, 0.4), {2});
  for (const Law law : {Law::coulomb, Law::ccp, Law::pyramid, Law::pyramid_k, Law::frictionless}) {
    contact::ContactProblem one = problem;
    one.law = law;
    const contact::ContactSolution s = solve(one, 1e-13);
    EXPECT_EQ(s.status, contact::SolveStatus::converged);
    EXPECT_LE(s.iterations, 2);
  }
}

TEST(Nsgs, ReachesEveryLaw) {
  for (const Law law : {Law::coulomb, Law::ccp, Law::pyramid, Law::pyramid_k, Law::frictionless})
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      contact::ContactProblem problem = test::random_heap(seed, 8, 14, 0.3);
      problem.law = law;
      const contact::ContactSolution s = solve(problem);
      EXPECT_EQ(s.status, contact::SolveStatus::converged) << seed;
      const contact::Residuals m = contact::measure(problem, s.r, s.v);
      EXPECT_LE(m.law_map_m_s, 1e-10) << seed;
      EXPECT_LT(m.momentum_sqrtJ, 1e-12) << seed;
    }
}

TEST(Nsgs, BothFormsMakeTheSameSweeps) {
  for (const Law law : {Law::coulomb, Law::ccp, Law::pyramid, Law::pyramid_k, Law::frictionless}) {
    contact::ContactProblem problem = test::random_heap(5, 6, 12, 0.3);
    problem.law = law;
    const NsgsSolver solver({.shared = {.tolerance = 0, .max_iterations = 7}});
    EXPECT_LT((solver.solve(problem, {}).r - solver.solve(contact::reduce(problem), {}).r).norm(), 1e-12);
  }
}

TEST(Nsgs, DuplicatesShareTheImpulse) {
  contact::ContactProblem problem = test::random_heap(8, 5, 8, 0.3);
  problem.law = Law::coulomb;
  const contact::ContactSolution one = solve(problem, 1e-12), two = solve(test::with_duplicates(problem), 1e-12);
  EXPECT_LT((one.v - two.v).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((one.r - two.r.head(one.r.size()) - two.r.tail(one.r.size())).norm(), 1e-8);
}

TEST(Nsgs, AWarmStartFromTheAnswerIsDoneAtOnce) {
  contact::ContactProblem problem = test::raft(6, 0.3, 0.8, 2);
  for (const Law law : {Law::coulomb, Law::ccp, Law::pyramid_k}) {
    problem.law = law;
    const contact::ContactSolution cold = solve(problem, 1e-10);
    const contact::ContactSolution warm =
        NsgsSolver({.shared = {.tolerance = 1e-9, .max_iterations = 1000}}).solve(problem, cold.r);
    EXPECT_LE(warm.iterations, 2) << static_cast<int>(law);
    EXPECT_GT(cold.iterations, 10);
  }
}

TEST(Nsgs, SaysWhenItStallsAndReturnsItsBest) {
  // The masses are 1e6 on 1. A sweep stops the lower body, then gives both M/(M + m) times the speed; that is no
  // progress.
  const double ratio = 1e6;
  contact::ContactProblem problem = test::column({1.0, ratio}, k_step, k_gravity);
  problem.law = Law::coulomb;
  const contact::ContactSolution s = solve(problem);
  EXPECT_EQ(s.status, contact::SolveStatus::stalled);
  EXPECT_GE(s.iterations, SweepSettings{}.stall_sweeps);
  EXPECT_LT(s.iterations, 4 * SweepSettings{}.stall_sweeps);
  const double left = k_gravity * k_step * std::pow(ratio / (ratio + 1), s.iterations);
  EXPECT_NEAR(contact::measure(problem, s.r).law_map_m_s, left, 1e-12);
  EXPECT_NEAR(s.v[2], -left, 1e-12);
  EXPECT_NEAR(s.v[8], -left, 1e-12);
}

TEST(Nsgs, StopsWithinItsBudget) {
  const contact::ContactProblem problem = test::column(std::vector<double>(200, 1.0), k_step, k_gravity);
  const contact::ContactSolution few = solve(problem, 1e-12, 50);
  EXPECT_EQ(few.status, contact::SolveStatus::iteration_limit);
  EXPECT_EQ(few.iterations, 50);
  const auto start = std::chrono::steady_clock::now();
  const contact::SolverSettings shared{.tolerance = 1e-14, .max_iterations = 1000000000, .max_seconds = 0.05};
  EXPECT_NE(NsgsSolver({.shared = shared}).solve(problem, {}).status, contact::SolveStatus::converged);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 1);
}

TEST(Nsgs, AHistoryDoesNotChangeTheAnswer) {
  const contact::ContactProblem problem = test::random_heap(3, 8, 14, 0.3);
  contact::SolverSettings shared{.tolerance = 1e-8, .max_iterations = 100000};
  const contact::ContactSolution plain = NsgsSolver({.shared = shared}).solve(problem, {});
  shared.keep_history = true;
  const contact::ContactSolution watched = NsgsSolver({.shared = shared}).solve(problem, {});
  EXPECT_EQ(plain.r, watched.r);
  EXPECT_TRUE(plain.history.empty());
  EXPECT_EQ(watched.history.size(), static_cast<std::size_t>(watched.iterations));
}

TEST(Nsgs, SymmetricSweepsReachTheSameAnswer) {
  contact::ContactProblem problem = test::raft(4, 0.3, 1.0, 2);
  problem.law = Law::ccp;  // The problem is convex: its motion is unique.
  const contact::SolverSettings shared{.tolerance = 1e-10, .max_iterations = 100000};
  const contact::ContactSolution there = NsgsSolver({.shared = shared}).solve(problem, {});
  const contact::ContactSolution back = NsgsSolver({.shared = shared, .symmetric_sweeps = true}).solve(problem, {});
  EXPECT_EQ(back.status, contact::SolveStatus::converged);
  EXPECT_LT((there.v - back.v).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(Nsgs, SameBitsForOneAndTwoThreads) {
  contact::ContactProblem problem = test::random_heap(11, 200, 80, 0.3);
  problem.law = Law::coulomb;
  const contact::ContactSolution one = solve(problem, 1e-10, 100000, 1), two = solve(problem, 1e-10, 100000, 2);
  EXPECT_EQ(one.r, two.r);
  EXPECT_EQ(one.v, two.v);
  EXPECT_EQ(one.iterations, two.iterations);
}

TEST(Nsgs, NamesAContactThatCannotYield) {
  contact::ContactProblem problem = test::random_heap(3, 4, 5, 0.4);
  problem.law = Law::coulomb;
  problem.add_contact(-1, MatX(3, 0), -1, MatX(3, 0), 77);
  problem.w[15] = -1;
  for (const contact::ContactSolution& s : {solve(problem), NsgsSolver({}).solve(contact::reduce(problem), {})}) {
    EXPECT_EQ(s.status, contact::SolveStatus::numerical_error);
    EXPECT_NE(s.message.find("key 77"), std::string::npos) << s.message;
  }
  problem.force_limit.back() = 2;
  const contact::ContactSolution crushed = solve(problem);
  EXPECT_EQ(crushed.status, contact::SolveStatus::converged);
  EXPECT_EQ(crushed.r[15], 2);
}

TEST(Nsgs, RefusesWhatIsNotFinite) {
  contact::ContactProblem problem = test::random_heap(3, 4, 5, 0.4);
  problem.f[2] = std::nan("");
  EXPECT_EQ(solve(problem).status, contact::SolveStatus::numerical_error);
}

contact::ContactSolution with_momentum(const contact::ContactProblem& problem, double tolerance, int threads = 1) {
  const contact::SolverSettings shared{.tolerance = tolerance, .max_iterations = 20000, .threads = threads};
  return NsgsSolver({.shared = shared, .has_momentum = true}).solve(problem, {});
}

/// Where plain sweeps contract slowly, as in columns, stacks and closed rafts, momentum takes less than two thirds of
/// them and meets the law. Laws: a cone, a convex one, and rows.
TEST(Nsgs, MomentumTakesFewerSweeps) {
  for (const Law law : {Law::coulomb, Law::ccp, Law::pyramid})
    for (contact::ContactProblem problem :
         {test::column(std::vector<double>(20, 3.0), k_step, k_gravity),
          test::box_stack(std::vector<double>(8, 2.0), 0.5), test::raft(6, 0.3, 1, 1), test::raft(6, 0.6, 1, 2)}) {
      problem.law = law;
      constexpr double k_tolerance = 1e-3;
      const contact::ContactSolution plain = solve(problem, k_tolerance), fast = with_momentum(problem, k_tolerance);
      EXPECT_EQ(fast.status, contact::SolveStatus::converged) << problem.num_contacts();
      EXPECT_LE(contact::measure(problem, fast.r).law_map_m_s, k_tolerance);
      EXPECT_LT(3 * fast.iterations, 2 * plain.iterations) << static_cast<int>(law) << " " << problem.num_contacts();
    }
}

/// Heaps in which a contact can have several answers, with guesses from far outside of the cones.
TEST(Nsgs, MomentumLeadsToTheLaw) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const contact::ContactProblem problem = test::random_heap(seed, 8, 16, 0.3);
    const contact::ContactSolution s = with_momentum(problem, 1e-10);
    EXPECT_EQ(s.status, contact::SolveStatus::converged) << seed;
    EXPECT_LE(contact::measure(problem, s.r).law_map_m_s, 1e-10) << seed;
    EXPECT_LT((s.v - solve(problem).v).cwiseAbs().maxCoeff(), 1e-8) << seed;
  }
}

TEST(Nsgs, MomentumKeepsItsBitsWithThreads) {
  const contact::ContactProblem problem = test::raft(20, 0.3, 1, 1);  // 1520 contacts: a large island
  const contact::ContactSolution one = with_momentum(problem, 1e-4);
  for (const int threads : {2, 3}) EXPECT_EQ(with_momentum(problem, 1e-4, threads).r, one.r) << threads;
}

}  // namespace nsgs_test
}  // namespace nilas::solvers
