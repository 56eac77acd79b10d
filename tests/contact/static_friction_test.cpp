/// Closed forms of blocks that stick, break loose, slide and come to rest.
#include "contact/static_friction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/problem/row_of.h"
#include "contact/registry.h"
#include "tests/support/problems/cone_problems.h"

namespace nilas::contact {
namespace static_friction_test {

constexpr double k_gravity = 9.81, k_step = 1e-3, k_mass = 4, k_static = 0.5, k_kinetic = 0.3;

/// One step of a block on a level plane, pushed by `force` [N] along t1.
ContactProblem pushed(double speed, double force) {
  ContactProblem problem =
      test::particle(Law::coulomb, k_mass, k_kinetic, {-k_gravity * k_step, speed + force / k_mass * k_step, 0});
  problem.mu_static[0] = k_static;
  return problem;
}

class StaticFrictionOf : public testing::TestWithParam<const char*> {
 protected:
  double step(double speed, double force) {
    ContactProblem problem = pushed(speed, force);
    const StaticFrictionSolution found = solve_with_static_friction({}, *solver_, {}, slipping_, problem);
    const ContactSolution& solution = found.solution;
    slipping_ = found.slipping;
    rounds_ = found.rounds;
    EXPECT_EQ(solution.status, SolveStatus::converged);
    EXPECT_LE(measure(problem, solution.r).law_map_m_s, 1e-12);
    used_ = problem.mu[0];
    return solution.u[1];
  }

  std::unique_ptr<solvers::ContactSolver> solver_ =
      find_solver(GetParam()).make({.tolerance = 1e-12, .max_iterations = 10000});
  SlippingContacts slipping_;
  int rounds_ = 0;
  double used_ = 0;
};

TEST_P(StaticFrictionOf, ABlockHoldsToTheStaticLimitAndThenLosesTheDifference) {
  const double limit = k_static * k_mass * k_gravity;
  EXPECT_NEAR(step(0, 0.99 * limit), 0, 1e-12);
  EXPECT_EQ(used_, k_static);
  const double gained = step(0, 1.01 * limit);
  EXPECT_EQ(used_, k_kinetic);
  EXPECT_NEAR(gained, (1.01 * limit / k_mass - k_kinetic * k_gravity) * k_step, 1e-12);
  EXPECT_EQ(rounds_, 2);
}

TEST_P(StaticFrictionOf, WhatSlidesKeepsSlidingBetweenTheTwoLimits) {
  const double force = 0.4 * k_mass * k_gravity;  // The force is above the kinetic limit and below the static one.
  EXPECT_NEAR(step(0, force), 0, 1e-12);
  double speed = step(2, force);
  EXPECT_NEAR(speed, 2 + (0.4 - k_kinetic) * k_gravity * k_step, 1e-12);
  speed = 1e-3;  // The speed is low enough for the static limit to stop the block, but the block was slipping.
  EXPECT_NEAR(step(speed, force), speed + (0.4 - k_kinetic) * k_gravity * k_step, 1e-12);
}

TEST_P(StaticFrictionOf, WhatComesToRestHoldsAgain) {
  EXPECT_GT(step(1, 0), 0.9);
  EXPECT_NEAR(step(1e-3, 0), 0, 1e-12);  // Kinetic friction stops the block.
  EXPECT_EQ(used_, k_kinetic);
  EXPECT_NEAR(step(0, 0.45 * k_mass * k_gravity), 0, 1e-12);
  EXPECT_EQ(used_, k_static);
}

INSTANTIATE_TEST_SUITE_P(Solvers, StaticFrictionOf, testing::Values("nsgs", "newton", "auto", "pgs"),
                         [](const auto& each) { return std::string(each.param); });

TEST(StaticFriction, BreaksAChainLooseContactByContact) {
  // Blocks stand side by side on a plane without connection. Each has its own limit: the weak ones slide, the others
  // stick.
  ContactProblem problem;
  std::vector<double> pushes{0.2, 0.45, 0.55, 0.7};
  for (std::size_t k = 0; k < pushes.size(); ++k) {
    problem.add_block(k_mass * Mat3::Identity());
    problem.f.tail<3>() = k_mass * Vec3(-k_gravity * k_step, pushes[k] * k_gravity * k_step, 0);
    problem.add_contact(-1, MatX(3, 0), static_cast<int>(k), Mat3::Identity(), k + 1);
    problem.mu.back() = k_kinetic;
    problem.mu_static.back() = k_static;
  }
  const auto solver = find_solver("auto").make({.tolerance = 1e-12});
  const ContactSolution solution = solve_with_static_friction({}, *solver, {}, {}, problem).solution;
  EXPECT_EQ(problem.mu, (std::vector<double>{k_static, k_static, k_kinetic, k_kinetic}));
  for (std::size_t k = 0; k < pushes.size(); ++k) {
    const double expected = pushes[k] > k_static ? (pushes[k] - k_kinetic) * k_gravity * k_step : 0;
    EXPECT_NEAR(solution.u[row_of(k) + 1], expected, 1e-12);
  }
}

TEST(StaticFriction, ATrialLeavesNoTrace) {
  const auto solver = find_solver("auto").make({.tolerance = 1e-12});
  const SlippingContacts slipped{1};
  ContactProblem once = pushed(1, 0), again = once;
  const auto first = solve_with_static_friction({}, *solver, {}, slipped, once);
  const auto second = solve_with_static_friction({}, *solver, {}, slipped, again);
  EXPECT_EQ(first.solution.r, second.solution.r);
  EXPECT_EQ(first.slipping, second.slipping);
}

TEST(StaticFriction, EqualCoefficientsTakeOneRound) {
  ContactProblem problem = test::particle(Law::coulomb, 1, 0.4, {-1, 3, 0});
  const auto solver = find_solver("auto").make({.tolerance = 1e-10});
  const StaticFrictionSolution found = solve_with_static_friction({}, *solver, {}, {}, problem);
  EXPECT_EQ(found.rounds, 1);
  EXPECT_NEAR(found.solution.u[1], 2.6, 1e-9);
}

}  // namespace static_friction_test
}  // namespace nilas::contact
