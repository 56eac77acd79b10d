/// Closed forms, mass ratios, random heaps and stated residuals of the solvers of convex problems.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/registry.h"
#include "contact/solvers/admm.h"
#include "contact/solvers/ipm.h"
#include "contact/solvers/shared/second_order_cone.h"
#include "core/base/error.h"
#include "tests/support/problems/cone_problems.h"

namespace nilas::solvers {
namespace cone_solvers_test {

constexpr double k_infinite = std::numeric_limits<double>::infinity();

struct Subject {
  std::string solver;
  int most;  ///< iterations
};
std::ostream& operator<<(std::ostream& out, const Subject& subject) { return out << subject.solver; }

class ConeSolver : public testing::TestWithParam<Subject> {
 protected:
  std::unique_ptr<ContactSolver> solver(double tolerance, int most = GetParam().most) const {
    return contact::find_solver(GetParam().solver).make({.tolerance = tolerance, .max_iterations = most});
  }

  contact::ContactSolution solve(const contact::ContactProblem& problem, double tolerance = 1e-12) const {
    return solver(tolerance)->solve(problem, {});
  }

  void expect_velocity(const contact::ContactProblem& problem, const Vec3& expected) const {
    test::expect_velocity(solve(problem), expected, 1e-11);
  }
};

TEST_P(ConeSolver, ObliqueImpactShowsTheLaw) {
  const double v = 1, w = 3;
  for (const double mu : {0.1, 0.5, 2.0}) {
    const double lift = (w - mu * v) / (1 + mu * mu);
    expect_velocity(test::particle(Law::coulomb, 3, mu, {-v, w, 0}), {0, w - mu * v, 0});
    expect_velocity(test::particle(Law::ccp, 3, mu, {-v, w, 0}), {mu * lift, lift, 0});
    expect_velocity(test::particle(Law::frictionless, 3, mu, {-v, w, 0}), {0, w, 0});
  }
}

TEST_P(ConeSolver, OneContactOpensOrSticks) {
  for (const Law law : {Law::coulomb, Law::ccp}) {
    expect_velocity(test::particle(law, 3, 0.5, {2, 2, -3}), {2, 2, -3});  // inside the dual cone, too
    expect_velocity(test::particle(law, 3, 0.5, {-2, 0.6, -0.7}), {0, 0, 0});
    expect_velocity(test::particle(law, 3, 0, {-2, 0.6, -0.7}), {0, 0.6, -0.7});
  }
}

TEST_P(ConeSolver, ForceLimitCrushesAndComplianceYields) {
  for (const Law law : {Law::coulomb, Law::ccp, Law::frictionless}) {
    contact::ContactProblem problem = test::particle(law, 2, 0.5, {-3, 0, 0});
    problem.force_limit[0] = 4;
    const contact::ContactSolution crushed = solve(problem);
    EXPECT_EQ(crushed.status, contact::SolveStatus::converged);
    EXPECT_NEAR(crushed.r[0], 4, 1e-10);
    problem.force_limit[0] = 7;
    EXPECT_NEAR(solve(problem).r[0], 6, 1e-10);
    problem.force_limit[0] = k_infinite;
    problem.compliance[0] = 0.25;
    EXPECT_NEAR(solve(problem).r[0], 3 / (0.5 + 0.25), 1e-10);
  }
}

TEST_P(ConeSolver, LimitedImpulseBoundsFriction) {
  // At the limit the particle moves on into the plane, and slides with friction mu times the limit.
  contact::ContactProblem problem = test::particle(Law::coulomb, 2, 0.5, {-3, 5, 0});
  problem.force_limit[0] = 4;
  expect_velocity(problem, {-1, 4, 0});
}

TEST_P(ConeSolver, ImmovableSidesAreNamed) {
  contact::ContactProblem problem;
  problem.add_contact(-1, MatX(3, 0), -1, MatX(3, 0), 77);
  problem.w[0] = -1;
  const contact::ContactSolution s = solve(problem);
  EXPECT_EQ(s.status, contact::SolveStatus::numerical_error);
  EXPECT_NE(s.message.find("77"), std::string::npos);
  problem.force_limit[0] = 5;
  EXPECT_EQ(solve(problem).status, contact::SolveStatus::converged);
  EXPECT_EQ(solve(problem).r[0], 5);
}

TEST_P(ConeSolver, StackOfAnyMassRatioStands) {
  for (const double ratio : {1.0, 1e3, 1e6}) {
    const contact::ContactProblem problem = test::box_stack(test::growing_masses(10, ratio), 0.5);
    const contact::ContactSolution s = solve(problem, 1e-9);
    EXPECT_EQ(s.status, contact::SolveStatus::converged) << ratio;
    EXPECT_LT(s.u.cwiseAbs().maxCoeff(), 1e-8) << ratio;
    EXPECT_LE(contact::measure(problem, s.r).natural_map_m_s, 1e-9) << ratio;
  }
}

TEST_P(ConeSolver, RandomHeapsConverge) {
  for (const Law law : {Law::coulomb, Law::ccp, Law::frictionless})
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      contact::ContactProblem problem = test::random_heap(seed, 8, 12, 0.1 * static_cast<double>(seed % 5 + 1));
      problem.law = law;
      const contact::ContactSolution s = solve(problem, 1e-9);
      EXPECT_EQ(s.status, contact::SolveStatus::converged) << contact::to_string(law) << " seed " << seed;
      EXPECT_LE(contact::measure(problem, s.r).law_map_m_s, 1e-9);
    }
}

TEST(Ipm, SolvesConvexLawsWithoutTheFinish) {
  for (const Law law : {Law::ccp, Law::frictionless}) {
    contact::ContactProblem problem = test::random_heap(3, 20, 40, 0.3);
    problem.law = law;
    IpmSettings settings{.shared = {.tolerance = 1e-6, .max_iterations = 1000}};
    settings.finish_iterations = 0;
    const contact::ContactSolution s = IpmSolver(settings).solve(problem, {});
    EXPECT_EQ(s.status, contact::SolveStatus::converged) << contact::to_string(law);
    EXPECT_LE(contact::measure(problem, s.r).law_map_m_s, 1e-6) << contact::to_string(law);
  }
}

TEST_P(ConeSolver, RandomHeapsWithLimitsAndComplianceConverge) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    contact::ContactProblem problem = test::random_heap(seed, 8, 12, 0.3);
    problem.law = Law::ccp;
    for (std::size_t c = 0; c < 12; ++c) {
      if (c % 2 == 0) problem.force_limit[c] = 0.5;
      if (c % 3 == 0) problem.compliance[c] = 0.1;
      if (c % 4 == 0) problem.tangential_compliance[c] = 0.15;
      if (c % 5 == 0) problem.force_limit[c] = 0;
    }
    const contact::ContactSolution s = solve(problem, 1e-9);
    EXPECT_EQ(s.status, contact::SolveStatus::converged) << seed;
    EXPECT_LE(contact::measure(problem, s.r).law_map_m_s, 1e-9);
  }
}

TEST_P(ConeSolver, AsymmetricOperatorIsSolvedAsStored) {
  contact::LocalProblem problem = contact::reduce(test::random_heap(1, 8, 6, 0.3));
  for (std::size_t k = 0; k < problem.block.size(); ++k)
    problem.block[k](0, 1) += 1e-3 * std::sin(static_cast<double>(k));
  const contact::ContactSolution s = solver(1e-10)->solve(problem, {});
  EXPECT_EQ(s.status, contact::SolveStatus::converged);
  EXPECT_LE(contact::measure(problem, s.r).law_map_m_s, 1e-10);
}

TEST_P(ConeSolver, ConvergedIsWhatMeasureSays) {
  for (const double tolerance : {1e-2, 1e-5, 1e-8})
    for (const int most : {1, 5, 50, 500})
      for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const contact::ContactProblem problem = test::random_heap(seed, 5, 12, 0.6);
        const contact::ContactSolution s = solver(tolerance, most)->solve(problem, {});
        EXPECT_EQ(s.status == contact::SolveStatus::converged, contact::measure(problem, s.r).law_map_m_s <= tolerance);
        EXPECT_TRUE(s.r.allFinite());
      }
}

TEST_P(ConeSolver, GuessNearTheAnswerEndsAtOnce) {
  const contact::ContactProblem problem = test::random_heap(3, 8, 12, 0.3);
  const contact::ContactSolution cold = solve(problem, 1e-9);
  const contact::ContactSolution warm = solver(1e-9)->solve(problem, cold.r);
  EXPECT_EQ(warm.status, contact::SolveStatus::converged);
  EXPECT_EQ(warm.iterations, 0);
  EXPECT_LT((warm.r - cold.r).norm(), 1e-14 * cold.r.norm());
}

TEST_P(ConeSolver, SameBitsEveryTime) {
  const contact::ContactProblem problem = test::random_heap(4, 8, 14, 0.4);
  EXPECT_EQ((solve(problem).r - solve(problem).r).norm(), 0);
}

TEST_P(ConeSolver, RefusesPyramids) {
  contact::ContactProblem problem = test::particle(Law::pyramid, 1, 0.5, {-1, 0, 0});
  EXPECT_THROW(solve(problem), InputError);
}

INSTANTIATE_TEST_SUITE_P(All, ConeSolver, testing::Values(Subject{"admm", 20000}, Subject{"ipm", 1000}),
                         [](const auto& each) { return each.param.solver; });

TEST(Admm, AccelerationReachesTheSameVelocities) {
  const contact::ContactProblem problem = test::box_stack({1, 10, 100}, 0.5);
  AdmmSettings plain{.shared = {.tolerance = 1e-10, .max_iterations = 20000}, .anderson_depth = 0};
  const AdmmSettings quick{.shared = plain.shared};
  const contact::ContactSolution slow = AdmmSolver(plain).solve(problem, {});
  EXPECT_EQ(slow.status, contact::SolveStatus::converged);
  EXPECT_LT((slow.u - AdmmSolver(quick).solve(problem, {}).u).norm(), 1e-8);
}

TEST(Ipm, ScalingTakesBothPointsToOne) {
  RandomStream random(1, "cone");
  for (int k = 0; k < 100; ++k) {
    const auto inside = [&] {
      const Vec3 t = test::random_vector(random);
      return Vec3(contact::tangential_norm(t) + std::exp(4 * random.normal()), t[1], t[2]);
    };
    const Vec3 x = inside(), z = inside();
    const NesterovTodd nt = nesterov_todd(x, z);
    EXPECT_LT((nt.scaling * x - nt.inverse * z).norm(), 1e-9 * nt.scaled.norm());
    EXPECT_LT((nt.scaling * nt.inverse - Mat3::Identity()).norm(), 1e-6);
    EXPECT_LT((jordan_product(x, jordan_quotient(z, x)) - z).norm(), 1e-9 * z.norm() * (1 + x[0] / cone_margin(x)));
    const Vec3 dx = test::random_vector(random);
    const double step = step_to_boundary(x, dx);
    if (std::isfinite(step)) {
      EXPECT_NEAR(cone_margin(x + step * dx) / (x[0] + step * dx.norm()), 0, 1e-12);
    } else {
      EXPECT_GE(cone_margin(dx), -1e-14);
    }
  }
}

}  // namespace cone_solvers_test
}  // namespace nilas::solvers
