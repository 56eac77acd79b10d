/// Closed forms of single contacts and small scenes.
#include "contact/solvers/pgs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "tests/support/cone_problems.h"

namespace nilas {
namespace {

constexpr double k_gravity = 9.81;

ContactSolution solve(const ContactProblem& problem, double tolerance = 1e-12, const VecX& guess = {}) {
  return PgsSolver({.shared = {.tolerance = tolerance, .max_iterations = 100000}}).solve(problem, guess);
}

void expect_velocity(const ContactProblem& problem, const Vec3& expected) {
  const ContactSolution s = solve(problem);
  EXPECT_EQ(s.status, SolveStatus::converged);
  EXPECT_LT((s.u - expected).norm(), 1e-14) << s.u.transpose();
  EXPECT_LT(measure(problem, s.r).law_map_m_s, 1e-12);
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
  ContactProblem problem = test::particle(Law::frictionless, 2, 0, {-3, 0, 0});
  problem.w[0] = 5;  // gap 0.05 over 0.01 s
  EXPECT_NEAR(solve(problem).v[0], -3, 1e-15);
  problem.w[0] = 1;
  EXPECT_NEAR(solve(problem).v[0], -1, 1e-15);
}

TEST(Pgs, RestitutionOfANormalImpact) {
  ContactProblem problem = test::particle(Law::coulomb, 2, 0.3, {-3, 0, 0});
  problem.w[0] = 0.8 * -3;
  EXPECT_NEAR(solve(problem).v[0], 2.4, 1e-14);
}

TEST(Pgs, ForceLimitCrushes) {
  for (const Law law : {Law::pyramid, Law::coulomb, Law::frictionless}) {
    ContactProblem problem = test::particle(law, 2, 0.5, {-3, 0, 0});
    problem.force_limit[0] = 4;
    const ContactSolution s = solve(problem);
    EXPECT_EQ(s.status, SolveStatus::converged);
    EXPECT_NEAR(s.r[0], 4, 1e-15);
    EXPECT_NEAR(s.u[0], -1, 1e-15);
    problem.force_limit[0] = 7;
    EXPECT_NEAR(solve(problem).r[0], 6, 1e-14);
  }
}

TEST(Pgs, ComplianceYields) {
  for (const Law law : {Law::pyramid, Law::coulomb, Law::frictionless}) {
    ContactProblem problem = test::particle(law, 2, 0.5, {-3, 0, 0});
    problem.compliance[0] = 0.25;
    const ContactSolution s = solve(problem);
    EXPECT_EQ(s.status, SolveStatus::converged);
    EXPECT_NEAR(s.r[0], 3 / (0.5 + 0.25), 1e-14);
    EXPECT_NEAR(s.u[0], -1, 1e-14);
  }
}

TEST(Pgs, HeadOnImpactOfTwoBodies) {
  const double m1 = 2, m2 = 5, v1 = 3, v2 = -1, e = 0.6;
  for (const double restitution : {0.0, e}) {
    ContactProblem problem;
    problem.law = Law::coulomb;
    std::vector<test::TestBody> bodies{{m1, Mat3::Identity(), Vec3(-1, 0, 0), Vec3(v1, 0, 0), Vec3::Zero()},
                                       {m2, 3 * Mat3::Identity(), Vec3(1, 0, 0), Vec3(v2, 0, 0), Vec3::Zero()}};
    for (const auto& body : bodies) test::add_body(problem, body);
    test::add_contact(problem, bodies, 0, 1, Vec3::Zero(), test::frame_of(Vec3::UnitX()), 0.4);
    problem.w[0] = restitution * (v2 - v1);
    const ContactSolution s = solve(problem);
    EXPECT_NEAR(s.v[0], ((m1 - restitution * m2) * v1 + (1 + restitution) * m2 * v2) / (m1 + m2), 1e-14);
    EXPECT_NEAR(s.v[6], ((m2 - restitution * m1) * v2 + (1 + restitution) * m1 * v1) / (m1 + m2), 1e-14);
  }
}

/// Slides a block on a level plane until it rests; semi-implicit Euler. Returns where it stops and when.
Vec3 slide(Law law, double speed, double direction, double mu, double h) {
  const double mass = 7;
  Vec3 v(0, speed * std::cos(direction), speed * std::sin(direction));
  Vec3 x = Vec3::Zero();
  double t = 0;
  while (v.norm() > 0 && t < 100) {
    ContactProblem problem = test::particle(law, mass, mu, v - Vec3(h * k_gravity, 0, 0));
    v = solve(problem, 1e-15).v;
    if (v.norm() < 1e-13) v.setZero();  // rounding is all that is left of the motion
    x += h * v;
    t += h;
  }
  return {t, x[1], x[2]};
}

/// sum of h (v0 - k mu g h)+ : the distance of one row under its own friction.
double row_distance(double v0, double mu, double h) {
  double sum = 0;
  for (int k = 1; v0 - k * mu * k_gravity * h > 0; ++k) sum += h * (v0 - k * mu * k_gravity * h);
  return sum;
}

TEST(Pgs, BoxPyramidFollowsItsOwnTrajectory) {
  const double v0 = 5, mu = 0.2, h = 1e-3, p = 30 * k_deg;
  const Vec3 stop = slide(Law::pyramid, v0, p, mu, h);
  EXPECT_NEAR(stop[1], row_distance(v0 * std::cos(p), mu, h), 1e-10);
  EXPECT_NEAR(stop[2], row_distance(v0 * std::sin(p), mu, h), 1e-10);
  EXPECT_NEAR(stop[1], 4.778, 4.778 * 1e-3);  // (v0 cos p)^2 / (2 mu g), to first order in h
  EXPECT_NEAR(stop[2], 1.593, 1.593 * 1e-3);
  EXPECT_NEAR(stop[0], 2.207, 2 * h);
}

TEST(Pgs, DiscStopsAtTheSameDistanceInEveryDirection) {
  const double v0 = 5, mu = 0.2, h = 1e-3;
  const double expected = row_distance(v0, mu, h);
  for (int azimuth = 0; azimuth < 360; azimuth += 15) {
    const Vec3 stop = slide(Law::coulomb, v0, azimuth * k_deg, mu, h);
    const Vec2 along(std::cos(azimuth * k_deg), std::sin(azimuth * k_deg));
    EXPECT_NEAR(stop.tail<2>().dot(along), expected, 1e-10) << azimuth;
    EXPECT_NEAR(along.x() * stop[2] - along.y() * stop[1], 0, 1e-10) << azimuth;
  }
}

TEST(Pgs, ClosingContactThatNothingCanMoveIsNamed) {
  ContactProblem problem = test::particle(Law::pyramid, 2, 0.5, {-2, 0, 0});
  problem.add_contact(-1, MatX(3, 0), -1, MatX(3, 0), 987);
  problem.w.tail<3>() << -0.3, 1, 0;
  ContactSolution s = solve(problem);
  EXPECT_EQ(s.status, SolveStatus::numerical_error);
  EXPECT_NE(s.message.find("987"), std::string::npos) << s.message;
  EXPECT_NEAR(s.u[0], 0, 1e-15);  // the other contact is solved all the same
  EXPECT_EQ(s.r[3], 0);
  problem.w[3] = 0.3;
  s = solve(problem);
  EXPECT_EQ(s.status, SolveStatus::converged);
  EXPECT_TRUE(s.message.empty());
}

TEST(Pgs, ForceLimitSaysWhatHappensWhereNothingCanMove) {
  for (const Law law : {Law::pyramid, Law::coulomb, Law::frictionless}) {
    ContactProblem problem;
    problem.law = law;
    problem.add_contact(-1, MatX(3, 0), -1, MatX(3, 0), 1);
    problem.mu[0] = problem.mu_static[0] = 0.5;
    problem.force_limit[0] = 8;
    problem.w << -0.3, 0.6, 0;
    const ContactSolution s = solve(problem);
    EXPECT_EQ(s.status, SolveStatus::converged);
    EXPECT_EQ(s.r[0], 8);
    EXPECT_NEAR(s.r[1], law == Law::frictionless ? 0 : -4, 1e-14);
    problem.w[0] = 0.3;
    EXPECT_EQ(solve(problem).r[0], 0);
  }
}

TEST(Pgs, ABodyThatCannotMoveAlongTheNormalIsNamedToo) {
  ContactProblem problem;  // free in heave only, pressed sideways against a wall by its carriage
  problem.law = Law::pyramid;
  problem.add_block(MatX::Constant(1, 1, 1500));
  MatX rows(3, 1);
  rows << 0, 1, 0;
  problem.add_contact(-1, MatX(3, 0), 0, rows, 55);
  problem.mu[0] = problem.mu_static[0] = 0.2;
  problem.w[0] = -0.1;
  EXPECT_EQ(solve(problem).status, SolveStatus::numerical_error);
  problem.force_limit[0] = 30;
  problem.f[0] = 1500 * 0.7;
  const ContactSolution s = solve(problem);
  EXPECT_EQ(s.status, SolveStatus::converged);
  EXPECT_EQ(s.r[0], 30);
  EXPECT_NEAR(s.v[0], 0.7 - 0.2 * 30 / 1500, 1e-15);
}

TEST(Pgs, InputThatIsNotFiniteIsANumericalError) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const ContactProblem good = test::random_heap(1, 4, 6, 0.3);
  for (const double bad : {nan, infinite}) {
    std::vector<ContactProblem> spoilt(6, good);
    spoilt[0].w[4] = bad;
    spoilt[1].f[2] = bad;
    spoilt[2].jacobian_data[7] = bad;
    spoilt[3].mass_data[35] = bad;
    spoilt[4].mu[1] = bad;
    spoilt[5].compliance[1] = bad;
    for (std::size_t k = 0; k < spoilt.size(); ++k) {
      const ContactSolution s = solve(spoilt[k]);
      EXPECT_EQ(s.status, SolveStatus::numerical_error) << k;
      EXPECT_FALSE(s.message.empty());
      EXPECT_EQ(s.r, VecX::Zero(18));
    }
  }
  VecX guess = VecX::Zero(18);
  guess[5] = nan;
  EXPECT_EQ(solve(good, 1e-6, guess).status, SolveStatus::numerical_error);
  ContactProblem indefinite = good;
  indefinite.mass_data[0] = -1;
  EXPECT_EQ(solve(indefinite).status, SolveStatus::numerical_error);
}

TEST(Pgs, NoContacts) {
  ContactProblem problem;
  problem.add_block(2 * Mat3::Identity());
  problem.f << 2, 4, 6;
  const ContactSolution s = solve(problem);
  EXPECT_EQ(s.status, SolveStatus::converged);
  EXPECT_EQ(s.r.size(), 0);
  EXPECT_LT((s.v - Vec3(1, 2, 3)).norm(), 1e-15);
}

TEST(Pgs, RefusesLawsItDoesNotKnowAndGuessesOfTheWrongSize) {
  EXPECT_THROW(solve(test::particle(Law::ccp, 1, 0.5, {-1, 0, 0})), InputError);
  EXPECT_THROW(solve(test::particle(Law::pyramid_k, 1, 0.5, {-1, 0, 0})), InputError);
  EXPECT_THROW(solve(test::particle(Law::pyramid, 1, 0.5, {-1, 0, 0}), 1e-6, VecX::Zero(4)), ContractError);
}

TEST(Pgs, AGuessIsMadeAdmissible) {
  const ContactProblem problem = test::particle(Law::coulomb, 3, 0.5, {-2, 3, -4});
  const ContactSolution cold = solve(problem);
  for (const Vec3& guess : {Vec3(-9, 1, 1), Vec3(0, 5, 5), Vec3(100, -99, 99)})
    EXPECT_LT((solve(problem, 1e-13, guess).u - cold.u).norm(), 1e-12);
}

}  // namespace
}  // namespace nilas
