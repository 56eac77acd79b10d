/// The residual of a known wrong impulse must equal its error.
#include "contact/measure/impulse_residual.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/measure/measure.h"

namespace nilas::contact {
namespace impulse_residual_test {

constexpr double k_mass = 2, k_mu = 0.3, k_weight = 0.2, k_slide = 1;  // kg, -, N s, N s

/// A particle on the ground that slides along t1 and is pressed down with k_weight over the step.
ContactProblem sliding(Law law) {
  ContactProblem problem;
  problem.h = 0.01;
  problem.law = law;
  problem.add_block(k_mass * Mat3::Identity());
  problem.add_contact(-1, MatX(3, 0), 0, Mat3::Identity(), 1);
  problem.mu[0] = k_mu;
  problem.f << -k_weight, k_slide, 0;
  return problem;
}

ImpulseResidual residual_of(const ContactProblem& problem, const Vec3& r, double gap_speed = 0) {
  std::vector<double> d;
  const VecX impulses = r, v = velocities(problem, impulses);
  const Residuals residuals = measure(PreparedProblem(problem), impulses, v, d);
  EXPECT_NEAR(d.at(0), 1 / k_mass, 1e-15);
  const ImpulseResidual e = impulse_residual(problem, 0, d[0], impulses, v, gap_speed);
  EXPECT_NEAR(d[0] * e.law.norm(), residuals.law_map_m_s, 1e-15);
  if (gap_speed == 0) {
    EXPECT_NEAR(d[0] * e.coulomb.norm(), residuals.natural_map_m_s, 1e-15);
  }
  return e;
}

TEST(ImpulseResidual, IsWhatTheImpulseIsOffForEveryComponent) {
  const Vec3 exact(k_weight, -k_mu * k_weight, 0);
  EXPECT_LT(residual_of(sliding(Law::coulomb), exact).law.norm(), 1e-16);
  // An error of friction stays the same, whatever the velocity.
  for (const double off : {1e-3, -2e-3}) {
    const ImpulseResidual e = residual_of(sliding(Law::coulomb), exact + Vec3(0, 0, off));
    EXPECT_NEAR(e.law.z(), off, 0.01 * std::abs(off));
    EXPECT_EQ(e.law, e.coulomb);
  }
  // Without friction an error of the normal impulse is found exactly.
  EXPECT_NEAR(residual_of(sliding(Law::frictionless), {k_weight + 0.01, 0, 0}).law.x(), 0.01, 1e-15);
}

TEST(ImpulseResidual, OfAPyramidIsTheFrictionBeyondTheCone) {
  ContactProblem problem = sliding(Law::pyramid);
  problem.f << -k_weight, k_slide, k_slide;
  const double bound = k_mu * k_weight;
  const ImpulseResidual e = residual_of(problem, {k_weight, -bound, -bound});
  EXPECT_LT(e.law.norm(), 1e-15);
  // Along the slip, both boxes at their bounds give sqrt(2) - 1 too much friction.
  const double along = e.coulomb.dot(Vec3(0, -1, -1)) / std::sqrt(2.0);
  EXPECT_NEAR(along, (std::sqrt(2.0) - 1) * bound / (1 + k_mu * k_mu), 1e-12);
}

TEST(ImpulseResidual, TheHoverOfAConvexifiedLawIsNoLoad) {
  // In steady sliding the gap h mu |u_T| that the law left in the last step is the gap that it requires in this one.
  ContactProblem problem = sliding(Law::ccp);
  const Vec3 exact(k_weight, -k_mu * k_weight, 0);
  const double hover = k_mu * (k_slide + exact.y()) / k_mass;
  problem.w[0] = hover;
  const ImpulseResidual e = residual_of(problem, exact, hover);
  EXPECT_LT(e.law.norm(), 1e-15);
  EXPECT_LT(e.coulomb.norm(), 1e-15);
  // Without a gap the particle leaves the ground, which Coulomb's law does not allow.
  EXPECT_GT(residual_of(problem, exact).coulomb.norm(), 0.1);
}

}  // namespace impulse_residual_test
}  // namespace nilas::contact
