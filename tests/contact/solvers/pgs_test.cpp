/// Closed forms of single contacts and small scenes.
#include "contact/solvers/pgs.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/error.h"
#include "tests/support/problems/cone_problems.h"

namespace nilas::solvers {
namespace pgs_test {

contact::ContactSolution solve(const contact::ContactProblem& problem, double tolerance = 1e-12,
                               const VecX& guess = {}) {
  return PgsSolver({.shared = {.tolerance = tolerance, .max_iterations = 100000}}).solve(problem, guess);
}

void expect_velocity(const contact::ContactProblem& problem, const Vec3& expected) {
  const contact::ContactSolution s = solve(problem);
  test::expect_velocity(s, expected, 1e-14);
  EXPECT_LT(contact::measure(problem, s.r).law_map_m_s, 1e-12);
}

TEST(Pgs, OneContactOpens) {
  for (const Law law : {Law::pyramid, Law::coulomb, Law::frictionless})
    expect_velocity(test::particle(law, 3, 0.5, {1, 2, -3}), {1, 2, -3});
}

TEST(Pgs, OneContactSticks) {
  expect_velocity(test::particle(Law::pyramid, 3, 0.5, {-2, 0.9, -0.9}), {0, 0, 0});
  expect_velocity(test::particle(Law::coulomb, 3, 0.5, {-2, 0.6, -0.7}), {0, 0, 0});
}

TEST(Pgs, OneContactSlides) {
  // each row of the pyramid loses mu v on its own, the cone loses it along the slip
  expect_velocity(test::particle(Law::pyramid, 3, 0.5, {-2, 3, -4}), {0, 2, -3});
  expect_velocity(test::particle(Law::pyramid, 3, 0.5, {-2, 3, -0.5}), {0, 2, 0});
  expect_velocity(test::particle(Law::coulomb, 3, 0.5, {-2, 3, -4}), {0, 2.4, -3.2});
  expect_velocity(test::particle(Law::frictionless, 3, 0.5, {-2, 3, -4}), {0, 3, -4});
}

TEST(Pgs, ObliqueImpactOfExactCoulombDoesNotLift) {
  expect_velocity(test::particle(Law::coulomb, 1, 0.5, {-1, 3, 0}), {0, 2.5, 0});
}

TEST(Pgs, GapMayCloseButNotBeCrossed) {
  contact::ContactProblem problem = test::particle(Law::frictionless, 2, 0, {-3, 0, 0});
  problem.w[0] = 5;  // gap 0.05 over 0.01 s
  EXPECT_NEAR(solve(problem).v[0], -3, 1e-15);
  problem.w[0] = 1;
  EXPECT_NEAR(solve(problem).v[0], -1, 1e-15);
}

TEST(Pgs, RestitutionOfANormalImpact) {
  contact::ContactProblem problem = test::particle(Law::coulomb, 2, 0.3, {-3, 0, 0});
  problem.w[0] = 0.8 * -3;
  EXPECT_NEAR(solve(problem).v[0], 2.4, 1e-14);
}

TEST(Pgs, ForceLimitCrushes) {
  for (const Law law : {Law::pyramid, Law::coulomb, Law::frictionless}) {
    contact::ContactProblem problem = test::particle(law, 2, 0.5, {-3, 0, 0});
    problem.force_limit[0] = 4;
    const contact::ContactSolution s = solve(problem);
    EXPECT_EQ(s.status, contact::SolveStatus::converged);
    EXPECT_NEAR(s.r[0], 4, 1e-15);
    EXPECT_NEAR(s.u[0], -1, 1e-15);
    problem.force_limit[0] = 7;
    EXPECT_NEAR(solve(problem).r[0], 6, 1e-14);
  }
}

TEST(Pgs, ComplianceYields) {
  for (const Law law : {Law::pyramid, Law::coulomb, Law::frictionless}) {
    contact::ContactProblem problem = test::particle(law, 2, 0.5, {-3, 0, 0});
    problem.compliance[0] = 0.25;
    const contact::ContactSolution s = solve(problem);
    EXPECT_EQ(s.status, contact::SolveStatus::converged);
    EXPECT_NEAR(s.r[0], 3 / (0.5 + 0.25), 1e-14);
    EXPECT_NEAR(s.u[0], -1, 1e-14);
  }
}

TEST(Pgs, HeadOnImpactOfTwoBodies) {
  const double m1 = 2, m2 = 5, v1 = 3, v2 = -1, e = 0.6;
  for (const double restitution : {0.0, e}) {
    contact::ContactProblem problem;
    problem.law = Law::coulomb;
    std::vector<test::TestBody> bodies{{m1, Mat3::Identity(), Vec3(-1, 0, 0), Vec3(v1, 0, 0), Vec3::Zero()},
                                       {m2, 3 * Mat3::Identity(), Vec3(1, 0, 0), Vec3(v2, 0, 0), Vec3::Zero()}};
    for (const auto& body : bodies) test::add_body(problem, body);
    test::add_contact(problem, bodies, 0, 1, Vec3::Zero(), test::frame_of(Vec3::UnitX()), 0.4);
    problem.w[0] = restitution * (v2 - v1);
    const contact::ContactSolution s = solve(problem);
    EXPECT_NEAR(s.v[0], ((m1 - restitution * m2) * v1 + (1 + restitution) * m2 * v2) / (m1 + m2), 1e-14);
    EXPECT_NEAR(s.v[6], ((m2 - restitution * m1) * v2 + (1 + restitution) * m1 * v1) / (m1 + m2), 1e-14);
  }
}

TEST(Pgs, ClosingContactThatNothingCanMoveIsNamed) {
  contact::ContactProblem problem = test::particle(Law::pyramid, 2, 0.5, {-2, 0, 0});
  problem.add_contact(-1, MatX(3, 0), -1, MatX(3, 0), 987);
  problem.w.tail<3>() << -0.3, 1, 0;
  contact::ContactSolution s = solve(problem);
  EXPECT_EQ(s.status, contact::SolveStatus::numerical_error);
  EXPECT_NE(s.message.find("987"), std::string::npos) << s.message;
  EXPECT_NEAR(s.u[0], 0, 1e-15);  // the other contact is solved all the same
  EXPECT_EQ(s.r[3], 0);
  problem.w[3] = 0.3;
  s = solve(problem);
  EXPECT_EQ(s.status, contact::SolveStatus::converged);
  EXPECT_TRUE(s.message.empty());
}

TEST(Pgs, ForceLimitSaysWhatHappensWhereNothingCanMove) {
  for (const Law law : {Law::pyramid, Law::coulomb, Law::frictionless}) {
    contact::ContactProblem problem;
    problem.law = law;
    problem.add_contact(-1, MatX(3, 0), -1, MatX(3, 0), 1);
    problem.mu[0] = problem.mu_static[0] = 0.5;
    problem.force_limit[0] = 8;
    problem.w << -0.3, 0.6, 0;
    const contact::ContactSolution s = solve(problem);
    EXPECT_EQ(s.status, contact::SolveStatus::converged);
    EXPECT_EQ(s.r[0], 8);
    EXPECT_NEAR(s.r[1], law == Law::frictionless ? 0 : -4, 1e-14);
    problem.w[0] = 0.3;
    EXPECT_EQ(solve(problem).r[0], 0);
  }
}

TEST(Pgs, ABodyThatCannotMoveAlongTheNormalIsNamedToo) {
  contact::ContactProblem problem;  // free in heave only, pressed sideways against a wall by its carriage
  problem.law = Law::pyramid;
  problem.add_block(MatX::Constant(1, 1, 1500));
  MatX rows(3, 1);
  rows << 0, 1, 0;
  problem.add_contact(-1, MatX(3, 0), 0, rows, 55);
  problem.mu[0] = problem.mu_static[0] = 0.2;
  problem.w[0] = -0.1;
  EXPECT_EQ(solve(problem).status, contact::SolveStatus::numerical_error);
  problem.force_limit[0] = 30;
  problem.f[0] = 1500 * 0.7;
  const contact::ContactSolution s = solve(problem);
  EXPECT_EQ(s.status, contact::SolveStatus::converged);
  EXPECT_EQ(s.r[0], 30);
  EXPECT_NEAR(s.v[0], 0.7 - 0.2 * 30 / 1500, 1e-15);
}

TEST(Pgs, InputThatIsNotFiniteIsANumericalError) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const contact::ContactProblem good = test::random_heap(1, 4, 6, 0.3);
  for (const double bad : {nan, infinite}) {
    std::vector<contact::ContactProblem> spoilt(6, good);
    spoilt[0].w[4] = bad;
    spoilt[1].f[2] = bad;
    spoilt[2].jacobian_data[7] = bad;
    spoilt[3].mass_data[35] = bad;
    spoilt[4].mu[1] = bad;
    spoilt[5].compliance[1] = bad;
    for (std::size_t k = 0; k < spoilt.size(); ++k) {
      const contact::ContactSolution s = solve(spoilt[k]);
      EXPECT_EQ(s.status, contact::SolveStatus::numerical_error) << k;
      EXPECT_FALSE(s.message.empty());
      EXPECT_EQ(s.r, VecX::Zero(18));
    }
  }
  VecX guess = VecX::Zero(18);
  guess[5] = nan;
  EXPECT_EQ(solve(good, 1e-6, guess).status, contact::SolveStatus::numerical_error);
  contact::ContactProblem indefinite = good;
  indefinite.mass_data[0] = -1;
  EXPECT_EQ(solve(indefinite).status, contact::SolveStatus::numerical_error);
}

TEST(Pgs, NoContacts) {
  contact::ContactProblem problem;
  problem.add_block(2 * Mat3::Identity());
  problem.f << 2, 4, 6;
  const contact::ContactSolution s = solve(problem);
  EXPECT_EQ(s.status, contact::SolveStatus::converged);
  EXPECT_EQ(s.r.size(), 0);
  EXPECT_LT((s.v - Vec3(1, 2, 3)).norm(), 1e-15);
}

TEST(Pgs, RefusesLawsItDoesNotKnowAndGuessesOfTheWrongSize) {
  EXPECT_THROW(solve(test::particle(Law::ccp, 1, 0.5, {-1, 0, 0})), InputError);
  EXPECT_THROW(solve(test::particle(Law::pyramid_k, 1, 0.5, {-1, 0, 0})), InputError);
  EXPECT_THROW(solve(test::particle(Law::pyramid, 1, 0.5, {-1, 0, 0}), 1e-6, VecX::Zero(4)), ContractError);
}

TEST(Pgs, AGuessIsMadeAdmissible) {
  const contact::ContactProblem problem = test::particle(Law::coulomb, 3, 0.5, {-2, 3, -4});
  const contact::ContactSolution cold = solve(problem);
  for (const Vec3& guess : {Vec3(-9, 1, 1), Vec3(0, 5, 5), Vec3(100, -99, 99)})
    EXPECT_LT((solve(problem, 1e-13, guess).u - cold.u).norm(), 1e-12);
}

}  // namespace pgs_test
}  // namespace nilas::solvers
