#include "contact/measure/measure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/problems/cone_problems.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::contact {
namespace measure_test {

/// A particle of 2 kg on a fixed plane whose normal is its first axis: W = 1/2, d = 1/2, u = v.
ContactProblem particle(Law law, double mu) { return test::particle(law, 2, mu, Vec3::Zero()); }

/// r lies inside the cone, while the contact slides and opens: nearly every residual differs from zero.
const Vec3 k_r(4, 1, 0), k_v(0.3, -0.4, 0);

TEST(Measure, HandWorkedColumns) {
  const Residuals m = measure(particle(Law::coulomb, 0.5), k_r, k_v);
  // u_hat = (0.5, -0.4, 0), r - 2 u_hat = (3, 1.8, 0), nearest (3.12, 1.56, 0): d |(0.88, -0.56, 0)|
  EXPECT_NEAR(m.natural_map_m_s, 0.5 * std::sqrt(1.088), 1e-15);
  EXPECT_EQ(m.law_map_m_s, m.natural_map_m_s);
  EXPECT_NEAR(m.natural_map_rms_m_s, m.natural_map_m_s, 1e-15);
  // r - 2 u = (3.4, 1.8, 0), nearest (3.44, 1.72, 0)
  EXPECT_NEAR(m.ccp_map_m_s, 0.5 * std::sqrt(0.832), 1e-15);
  EXPECT_EQ(m.penetration_rate_m_s, 0);
  EXPECT_NEAR(m.complementarity_J, 1.2, 1e-15);
  EXPECT_EQ(m.cone_violation_m_s, 0);
  EXPECT_EQ(m.slip_angle_deg, 0);
  EXPECT_NEAR(m.creep_m_s, 0.2, 1e-15);
  EXPECT_NEAR(m.bipotential_J, 1.2 - 0.4 + 0.8, 1e-15);
  // M v - r = (-3.4, -1.8, 0) over sqrt(2)
  EXPECT_NEAR(m.momentum_sqrtJ, std::sqrt((3.4 * 3.4 + 1.8 * 1.8) / 2), 1e-14);
}

TEST(Measure, LawMapIsThatOfTheLawAsked) {
  EXPECT_NEAR(measure(particle(Law::ccp, 0.5), k_r, k_v).law_map_m_s, 0.5 * std::sqrt(0.832), 1e-15);
  // normal 4 - 3.4, tangent 1 - min(1.8, 2)
  EXPECT_NEAR(measure(particle(Law::pyramid, 0.5), k_r, k_v).law_map_m_s, 0.5 * std::hypot(0.6, 0.8), 1e-15);
  EXPECT_NEAR(measure(particle(Law::frictionless, 0.5), k_r, k_v).law_map_m_s, 0.3, 1e-15);
  // the diamond has a corner on T1: the same nearest point as the cone
  ContactProblem diamond = particle(Law::pyramid_k, 0.5);
  diamond.facets = 4;
  EXPECT_NEAR(measure(diamond, k_r, k_v).law_map_m_s, 0.5 * std::sqrt(1.088), 1e-15);
  // a velocity on the diagonal: the diamond's support is |u_1| = 0.4 there, the circle's 0.4 sqrt(2); with r in its
  // corner sector the point (4 - 2*(0.3 + 0.2), 0.8, 0.8) lies outside by (1.6 - 1.5)/sqrt(2) across the facet
  const Vec3 diagonal(0.3, -0.4, -0.4), inside(4, 0, 0);
  const double slope = 0.5 / std::sqrt(2), beyond = 1.6 / std::sqrt(2);
  const double height = (3 + slope * beyond) / (1 + slope * slope), reach = slope * height / std::sqrt(2);
  EXPECT_NEAR(measure(diamond, inside, diagonal).law_map_m_s, 0.5 * Vec3(4 - height, reach, reach).norm(), 1e-15);
}

TEST(Measure, ViolationsOfEachKind) {
  const ContactProblem problem = particle(Law::coulomb, 0.5);
  Residuals m = measure(problem, Vec3(2, 3, 4), Vec3(-0.25, 0, 0));
  EXPECT_NEAR(m.penetration_rate_m_s, 0.25, 1e-15);
  EXPECT_NEAR(m.cone_violation_m_s, 0.5 * (5 - 1), 1e-15);
  EXPECT_NEAR(m.complementarity_J, 0.5, 1e-15);
  m = measure(problem, Vec3(4, 2, 0), Vec3(0, -1, 1));
  EXPECT_NEAR(m.slip_angle_deg, 45, 1e-12);
  EXPECT_EQ(m.creep_m_s, 0);
  EXPECT_NEAR(m.bipotential_J, -2 + 0.5 * std::sqrt(2) * 4, 1e-15);
  m = measure(problem, Vec3(4, 2, 0), Vec3(0, 1, 0));  // The friction drives the slip.
  EXPECT_NEAR(m.slip_angle_deg, 180, 1e-12);
}

TEST(Measure, ExactSolutionsOfEachLaw) {
  // The cases are stick, slip and open for exact Coulomb friction.
  const ContactProblem problem = particle(Law::coulomb, 0.5);
  for (const auto& [r, v] : std::vector<std::pair<Vec3, Vec3>>{
           {Vec3(4, 1, -1), Vec3::Zero()}, {Vec3(5, -1.5, 2), Vec3(0, 0.3, -0.4)}, {Vec3::Zero(), Vec3(1, 2, 3)}}) {
    const Residuals m = measure(problem, r, v);
    EXPECT_LT(m.natural_map_m_s, 1e-15);
    EXPECT_LT(m.bipotential_J, 1e-15);
    EXPECT_LT(m.creep_m_s, 1e-15);
    EXPECT_LT(m.complementarity_J, 1e-15);
    EXPECT_LT(m.slip_angle_deg, 1e-6);
  }
  // the convexified law lifts while it slides: u_N = mu |u_T|
  const Residuals lifted = measure(particle(Law::ccp, 0.5), Vec3(5, -1.5, 2), Vec3(0.25, 0.3, -0.4));
  EXPECT_LT(lifted.law_map_m_s, 1e-15);
  EXPECT_GT(lifted.natural_map_m_s, 0.1);
}

TEST(Measure, RootMeanSquareAndLargestOverContacts) {
  ContactProblem problem = particle(Law::frictionless, 0);
  problem.add_block(2 * Mat3::Identity());
  problem.add_contact(-1, MatX(3, 0), 1, Mat3::Identity(), 2);
  VecX r = VecX::Zero(6), v = VecX::Zero(6);
  v[0] = -0.3;
  v[3] = -0.4;
  const Residuals m = measure(problem, r, v);
  EXPECT_NEAR(m.natural_map_m_s, 0.4, 1e-15);
  EXPECT_NEAR(m.natural_map_rms_m_s, std::sqrt(0.125), 1e-15);
}

/// 900 particles, of which every third rolls: four pieces for the threads.
TEST(Measure, SameBitsForAnyNumberOfThreads) {
  ContactProblem problem = particle(Law::coulomb, 0.5);
  for (int k = 1; k < 900; ++k) {
    problem.add_block((2 + 0.01 * k) * Mat3::Identity());
    problem.mu[problem.add_contact(-1, MatX(3, 0), k, Mat3::Identity(), 2 * static_cast<std::uint64_t>(k))] = 0.3;
  }
  for (int k = 0; k < 900; k += 3) problem.add_moment(k, MatX(3, 0), 0.1 * Mat3::Identity(), 0.1, 2 * k + 10001);
  VecX r(3 * problem.num_contacts()), v(problem.num_velocities());
  for (Eigen::Index i = 0; i < r.size(); ++i) r[i] = std::cos(1.7 * static_cast<double>(i)) + 0.5;
  for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = 0.1 * std::sin(2.3 * static_cast<double>(i));
  const PreparedProblem prepared(problem);
  const Residuals alone = measure(prepared, r, v);
  EXPECT_GT(alone.natural_map_m_s, 0);
  for (const int threads : {2, 3}) {
    const Residuals shared = measure(prepared, r, v, threads);
    for (const NamedResidual& column : residual_columns())
      EXPECT_EQ(alone.*column.member, shared.*column.member) << column.name;
  }
  const double worst = measure(prepared, r).law_map_m_s;
  for (const int threads : {1, 2, 3}) EXPECT_EQ(largest_law_map(prepared, r, threads), worst) << threads;
}

TEST(Measure, AForceLimitMakesCrushingLawful) {
  ContactProblem problem = particle(Law::coulomb, 0.5);
  problem.force_limit[0] = 2;
  for (const Law law : {Law::coulomb, Law::ccp, Law::pyramid, Law::frictionless}) {
    problem.law = law;
    const Residuals crushed = measure(problem, Vec3(2, 0, 0), Vec3(-3, 0, 0));
    EXPECT_EQ(crushed.law_map_m_s, 0);
    EXPECT_EQ(crushed.penetration_rate_m_s, 0);
    EXPECT_EQ(crushed.complementarity_J, 0);
    EXPECT_EQ(crushed.bipotential_J, 0);
  }
  problem.law = Law::coulomb;
  // sliding on the rim
  const Residuals sliding = measure(problem, Vec3(2, -1, 0), Vec3(-3, 5, 0));
  EXPECT_LT(sliding.law_map_m_s, 1e-15);
  EXPECT_LT(std::abs(sliding.bipotential_J), 1e-14);
  // Below the limit the contact may not close.
  const Residuals early = measure(problem, Vec3(1.5, 0, 0), Vec3(-3, 0, 0));
  EXPECT_NEAR(early.law_map_m_s, 0.25, 1e-15);
  EXPECT_NEAR(early.penetration_rate_m_s, 0.25, 1e-15);
  EXPECT_NEAR(early.complementarity_J, 1.5, 1e-15);
  EXPECT_NEAR(early.bipotential_J, 1.5, 1e-15);
}

TEST(Measure, ComplianceReplacesTheNormalVelocity) {
  ContactProblem problem = particle(Law::coulomb, 0.5);
  problem.compliance[0] = 0.1;
  const Residuals m = measure(problem, Vec3(5, 0, 0), Vec3(-0.5, 0, 0));
  EXPECT_LT(m.natural_map_m_s, 1e-15);
  EXPECT_LT(m.penetration_rate_m_s, 1e-15);
  EXPECT_NEAR(measure(problem, Vec3(5, 0, 0), Vec3(-0.6, 0, 0)).penetration_rate_m_s, 0.1, 1e-15);
}

TEST(Measure, TangentialComplianceReplacesTheSlip) {
  ContactProblem problem = particle(Law::coulomb, 0.5);
  problem.tangential_compliance[0] = 0.2;
  // u_T + c r_T = 0: the contact sticks, although its sides move past each other
  const Residuals stick = measure(problem, Vec3(5, -2, 1), Vec3(0, 0.4, -0.2));
  EXPECT_LT(stick.natural_map_m_s, 1e-15);
  EXPECT_LT(stick.law_map_m_s, 1e-15);
  EXPECT_LT(std::abs(stick.bipotential_J), 1e-14);
  EXPECT_EQ(stick.slip_angle_deg, 0);
  EXPECT_NEAR(measure(problem, Vec3(5, -2, 1), Vec3(0, 0.5, -0.2)).natural_map_m_s, std::hypot(0.1, 0.05), 1e-15);
}

TEST(Measure, BothSidesPrescribed) {
  ContactProblem problem;
  problem.law = Law::coulomb;
  problem.add_contact(-1, MatX(3, 0), -1, MatX(3, 0), 1);
  problem.w << -0.2, 0, 0;
  const VecX none;
  EXPECT_NEAR(measure(problem, Vec3(0, 0, 0), none).law_map_m_s, 0.2, 1e-15);
  EXPECT_NEAR(measure(problem, Vec3(9, 0, 0), none).penetration_rate_m_s, 0.2, 1e-15);
  problem.force_limit[0] = 7;
  EXPECT_EQ(measure(problem, Vec3(7, 0, 0), none).law_map_m_s, 0);
  EXPECT_NEAR(measure(problem, Vec3(6, 0, 0), none).law_map_m_s, 0.2, 1e-15);
  problem.w[0] = 0.2;
  EXPECT_EQ(measure(problem, Vec3(0, 0, 0), none).law_map_m_s, 0);
  EXPECT_NEAR(measure(problem, Vec3(7, 0, 0), none).law_map_m_s, 0.2, 1e-15);
  problem.compliance[0] = 0.5;  // With a compliance the contact yields: r_N = 0.2/0.5.
  problem.w[0] = -0.2;
  EXPECT_LT(measure(problem, Vec3(0.4, 0, 0), none).law_map_m_s, 1e-15);
  EXPECT_NEAR(measure(problem, Vec3(0.3, 0, 0), none).law_map_m_s, 0.05, 1e-15);
}

TEST(Measure, MassScalingLeavesVelocitiesAlone) {
  ContactProblem light = test::random_heap(1, 5, 9, 0.4);
  ContactProblem heavy = light;
  for (double& m : heavy.mass_data) m *= 1e6;
  heavy.f *= 1e6;
  RandomStream random(2, "impulses");
  const VecX r = VecX::NullaryExpr(27, [&](Eigen::Index) { return std::abs(random.normal()); });
  for (const Law law : {Law::coulomb, Law::ccp, Law::pyramid, Law::pyramid_k, Law::frictionless}) {
    light.law = heavy.law = law;
    const Residuals a = measure(light, r), b = measure(heavy, 1e6 * r);
    EXPECT_NEAR(b.law_map_m_s, a.law_map_m_s, 1e-12 * a.law_map_m_s);
    EXPECT_NEAR(b.natural_map_m_s, a.natural_map_m_s, 1e-12 * a.natural_map_m_s);
    EXPECT_NEAR(b.bipotential_J, 1e6 * a.bipotential_J, 1e-5 * std::abs(a.bipotential_J));
  }
}

TEST(Measure, VelocitiesFromTheImpulsesBalanceMomentum) {
  const ContactProblem problem = test::random_heap(3, 8, 15, 0.4);
  const VecX r = VecX::Constant(45, 0.7);
  EXPECT_LT(measure(problem, r).momentum_sqrtJ, 1e-13);
}

TEST(Measure, NaNIsNeverHidden) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ContactProblem problem = test::random_heap(3, 4, 6, 0.4);
  VecX r = VecX::Zero(18);
  r[7] = nan;
  for (const Law law : {Law::coulomb, Law::ccp, Law::pyramid, Law::pyramid_k, Law::frictionless}) {
    problem.law = law;
    EXPECT_TRUE(std::isnan(measure(problem, r).natural_map_m_s));
    const double law_map = measure(problem, r).law_map_m_s;
    EXPECT_TRUE(law == Law::frictionless || std::isnan(law_map));
    const double alone = largest_law_map(PreparedProblem(problem), r);
    EXPECT_TRUE(std::isnan(law_map) ? std::isnan(alone) : alone == law_map);
  }
}

TEST(Measure, ColumnsInOrder) {
  ASSERT_EQ(residual_columns().size(), 11u);
  EXPECT_STREQ(residual_columns().front().name, "law_map_m_s");
  EXPECT_STREQ(residual_columns().back().name, "momentum_sqrtJ");
  Residuals m;
  m.creep_m_s = 3;
  EXPECT_EQ(m.*residual_columns()[8].member, 3);
}

}  // namespace measure_test
}  // namespace nilas::contact
