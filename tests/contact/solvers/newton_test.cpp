#include "contact/solvers/newton.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/problems/cone_problems.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::solvers {
namespace newton_test {

constexpr Law k_laws[] = {Law::coulomb, Law::ccp, Law::pyramid, Law::pyramid_k, Law::frictionless};

template <class Problem>
contact::ContactSolution solve(const Problem& problem, const VecX& guess = {}, double tolerance = 1e-11) {
  return NewtonSolver({.shared = {.tolerance = tolerance}}).solve(problem, guess);
}

TEST(Newton, ParticleShowsTheArtefactOfEachLaw) {
  const auto solved = [](Law law) { return solve(test::particle(law, 2, 0.5, {-1, 3, 0})); };
  test::expect_velocity(solved(Law::coulomb), {0, 2.5, 0}, 1e-11);
  test::expect_velocity(solved(Law::ccp), {1, 2, 0}, 1e-11);
  test::expect_velocity(solved(Law::frictionless), {0, 3, 0}, 1e-12);
}

TEST(Newton, ParticleSticksBelowTheConeAndIsCrushedAtTheLimit) {
  test::expect_velocity(solve(test::particle(Law::coulomb, 2, 0.5, {-1, 0.4, 0})), Vec3::Zero(), 1e-11);
  contact::ContactProblem problem = test::particle(Law::coulomb, 2, 0.5, {-1, 3, 0});
  problem.force_limit[0] = 1;  // 2 N s would stop the particle.
  test::expect_velocity(solve(problem), {-0.5, 2.75, 0}, 1e-12);
}

TEST(Newton, ComplianceYields) {
  contact::ContactProblem problem = test::particle(Law::coulomb, 2, 0.5, {-1, 0, 0});
  problem.compliance[0] = 0.5;  // The compliance equals that of the mass.
  EXPECT_NEAR(solve(problem).v[0], -0.5, 1e-12);
}

TEST(Newton, RandomHeapsUnderEveryLaw) {
  for (const Law law : k_laws)
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      contact::ContactProblem problem = test::random_heap(seed, 8, 16, 0.3);
      problem.law = law;
      const contact::ContactSolution solution = solve(problem);
      EXPECT_EQ(solution.status, contact::SolveStatus::converged) << static_cast<int>(law) << " " << seed;
      EXPECT_LT(contact::measure(problem, solution.r).law_map_m_s, 1e-10);
    }
}

TEST(Newton, ForceLimitsAndComplianceOfHeaps) {
  for (const Law law : k_laws)
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      contact::ContactProblem problem = test::random_heap(seed, 8, 14, 0.3);
      problem.law = law;
      for (std::size_t c = 0; c < problem.pairs.size(); ++c) {
        if (c % 3 == 0) problem.force_limit[c] = 0.2;
        if (c % 3 == 1) problem.compliance[c] = 0.3;
        if (c % 3 == 1) problem.tangential_compliance[c] = 0.4;
      }
      EXPECT_EQ(solve(problem).status, contact::SolveStatus::converged) << static_cast<int>(law) << " " << seed;
    }
}

TEST(Newton, ColumnWithMassRatioAMillion) {
  std::vector<double> masses(8);
  for (std::size_t k = 0; k < masses.size(); ++k) masses[k] = std::pow(10.0, 6.0 * static_cast<double>(k) / 7);
  contact::ContactProblem problem = test::column(masses, 0.01, 9.81);
  // M^-1 (f + H r) of the lightest body is rounded to 2e-11 m/s
  const contact::ContactSolution solution = solve(problem, {}, 1e-10);
  ASSERT_EQ(solution.status, contact::SolveStatus::converged);
  double above = 0;
  for (int k = 7; k >= 0; --k) {
    above += masses[k];
    EXPECT_NEAR(solution.r[3 * k] / (0.01 * 9.81 * above), 1, 1e-8) << k;
  }
}

TEST(Newton, RedundantContactsLeaveTheMotionAlone) {
  contact::ContactProblem problem = test::random_heap(3, 6, 10, 0.4);
  const VecX v = solve(problem).v;
  for (int c = 0; c < 10; ++c) {
    const auto i = static_cast<std::size_t>(c);
    problem.add_contact(problem.pairs[i].a, MatX(problem.jacobian_a(c)), problem.pairs[i].b,
                        MatX(problem.jacobian_b(c)), 100 + i);
    problem.mu.back() = problem.mu_static.back() = problem.mu[i];
    problem.w.tail<3>() = problem.w.segment<3>(3 * c);
  }
  const contact::ContactSolution doubled = solve(problem);
  EXPECT_EQ(doubled.status, contact::SolveStatus::converged);
  EXPECT_LT((doubled.v - v).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Newton, StartsFromItsOwnSolutionWithoutAnIteration) {
  const contact::ContactProblem problem = test::raft(6, 0.3, 0.8, 1);
  const contact::ContactSolution first = solve(problem, {}, 1e-10);
  ASSERT_EQ(first.status, contact::SolveStatus::converged);
  const contact::ContactSolution again = solve(problem, first.r, 1e-10);
  EXPECT_EQ(again.status, contact::SolveStatus::converged);
  EXPECT_LE(again.iterations, 1);
}

TEST(Newton, LocalAndGlobalFormsAgree) {
  const contact::ContactProblem problem = test::random_heap(5, 6, 10, 0.5);
  EXPECT_EQ(solve(problem).r, solve(contact::reduce(problem)).r);
}

TEST(Newton, HistoryHoldsEveryIteration) {
  const contact::ContactSolution solution =
      NewtonSolver({.shared = {.tolerance = 1e-10, .keep_history = true}}).solve(test::raft(4, 0.3, 1, 2), {});
  ASSERT_EQ(static_cast<int>(solution.history.size()), solution.iterations);
  EXPECT_LE(solution.history.back(), 1e-10);
}

TEST(Newton, SlightlyAsymmetricW) {
  contact::LocalProblem problem = contact::reduce(test::random_heap(7, 6, 10, 0.4));
  for (std::size_t k = 0; k < problem.block.size(); ++k) problem.block[k](0, 1) *= 1 + 1e-3 * std::sin(double(k));
  EXPECT_GT(contact::asymmetry(problem), 1e-6);
  EXPECT_EQ(solve(problem).status, contact::SolveStatus::converged);
}

TEST(Newton, SaysWhatItCannotDo) {
  contact::ContactProblem problem = test::particle(Law::coulomb, 2, 0.5, {-1, 3, 0});
  problem.f[0] = std::numeric_limits<double>::quiet_NaN();
  const contact::ContactSolution bad = solve(problem);
  EXPECT_EQ(bad.status, contact::SolveStatus::numerical_error);
  EXPECT_NE(bad.message.find("finite"), std::string::npos);

  const contact::ContactSolution limited =
      NewtonSolver({.shared = {.tolerance = 1e-12, .max_iterations = 2}}).solve(test::raft(6, 0.3, 1, 2), {});
  EXPECT_EQ(limited.status, contact::SolveStatus::iteration_limit);
  EXPECT_LE(limited.iterations, 2);
}

TEST(Newton, NoContacts) {
  EXPECT_EQ(solve(contact::ContactProblem{}).status, contact::SolveStatus::converged);
  EXPECT_EQ(solve(contact::LocalProblem{}).status, contact::SolveStatus::converged);
}

}  // namespace newton_test
}  // namespace nilas::solvers
