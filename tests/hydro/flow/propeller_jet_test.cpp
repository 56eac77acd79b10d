#include "hydro/flow/propeller_jet.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nilas::hydro {

namespace propeller_jet_test {

constexpr double k_density = 1025;

/// 2 pi rho times the integral of u^2 r dr by Simpson's rule, out to where the Gaussian edge is below 1e-15.
double momentum_flux(const PropellerJet& jet, double x) {
  const double end = jet.jet_diameter() + 9 * k_jet_spread * x;
  constexpr int k_steps = 200000;
  const double h = end / k_steps;
  double sum = 0;
  for (int k = 0; k <= k_steps; ++k) {
    const double r = k * h, u = jet.speed(x, r);
    sum += (k == 0 || k == k_steps ? 1 : k % 2 == 1 ? 4 : 2) * u * u * r;
  }
  return 2 * k_pi * k_density * sum * h / 3;
}

/// The flux of momentum through each section is the thrust: in the near field, at its end x = D0 / (2 c), and far away.
/// Simpson's rule loses an order at the edge of the core, so 1e-9.
TEST(PropellerJet, MomentumFluxIsTheThrustEverywhere) {
  const double D = 3, T = 4e5;
  PropellerJet jet(D, k_density);
  jet.set({0, 0, -4}, {-1, 0, 0}, T);
  const double end_of_core = jet.jet_diameter() / (2 * k_jet_spread);
  for (const double x : {0.1, 1.0, 0.5 * end_of_core, 0.999 * end_of_core, end_of_core, 10.0, 30.0, 100.0, 500.0})
    EXPECT_NEAR(momentum_flux(jet, x), T, 1e-9 * T) << x;
}

/// V0 = sqrt(8 T / (pi rho D^2)), which is 1.60 n D sqrt(K_T); the published factor is 1.59 [Blaauw, van de Kaa 1978].
TEST(PropellerJet, EffluxVelocityIsThatOfMomentumTheory) {
  const double D = 3, n = 2, KT = 0.4, T = KT * k_density * n * n * std::pow(D, 4);
  PropellerJet jet(D, k_density);
  jet.set(Vec3::Zero(), {-1, 0, 0}, T);
  EXPECT_NEAR(jet.efflux_velocity(), std::sqrt(8 * T / (k_pi * k_density * D * D)), 1e-12);
  EXPECT_NEAR(jet.efflux_velocity() / (n * D * std::sqrt(KT)), 1.596, 1e-3);
  EXPECT_NEAR(jet.jet_diameter(), 0.7071 * D, 1e-4 * D);
}

/// On the axis: V0 to 2.63 D0, then 2.63 V0 D0 / x [2.6 to 2.8: Blaauw, van de Kaa 1978; Verheij 1983].
TEST(PropellerJet, AxisDecaysAsOneOverX) {
  PropellerJet jet(3, k_density);
  jet.set(Vec3::Zero(), {1, 0, 0}, 4e5);
  const double V0 = jet.efflux_velocity(), D0 = jet.jet_diameter();
  for (const double x : {0.0, 1.0, 2.6 * D0}) EXPECT_EQ(jet.speed(x, 0), V0) << x;
  for (const double x : {2.7 * D0, 10 * D0, 100 * D0})
    EXPECT_NEAR(jet.speed(x, 0), V0 * D0 / (2 * 0.19 * x), 1e-12 * V0) << x;
}

TEST(PropellerJet, IsBoundedContinuousAndOnlyBehindTheDisc) {
  PropellerJet jet(3, k_density);
  const Vec3 p(1, 2, -4), d = Vec3(-1, 0.3, 0.1).normalized(), across = d.cross(Vec3::UnitZ()).normalized();
  EXPECT_EQ(jet.velocity(p + d, 0), Vec3::Zero()) << "before the first thrust";
  jet.set(p, d, 4e5);
  const double V0 = jet.efflux_velocity();
  EXPECT_EQ(jet.velocity(p - 1e-6 * d, 0), Vec3::Zero());
  for (double x = 0.01; x < 40; x += 0.37)
    for (double r = 0; r < 8; r += 0.11) {
      const Vec3 u = jet.velocity(p + x * d + r * across, 3);
      EXPECT_LE(u.norm(), V0 * (1 + 1e-15));
      EXPECT_LT(u.cross(d).norm(), 1e-12 * V0);
      EXPECT_NEAR(u.norm(), jet.speed(x, r), 1e-9 * V0);
      // In the first metre the edge is as sharp as 0.19 x.
      if (x > 1) {
        EXPECT_NEAR(jet.speed(x + 1e-6, r), jet.speed(x, r), 1e-4 * V0);
      }
    }
  const double end = jet.jet_diameter() / (2 * k_jet_spread);
  for (const double r : {0.0, 0.5, 1.0, 2.0})
    EXPECT_NEAR(jet.speed(end * (1 - 1e-12), r), jet.speed(end * (1 + 1e-12), r), 1e-5 * V0) << r;
}

TEST(PropellerJet, LeavesToTheOtherSideWithThrustAstern) {
  PropellerJet jet(2, k_density);
  jet.set(Vec3::Zero(), {-1, 0, 0}, 1e5);
  const Vec3 ahead = jet.velocity({-5, 0.4, 0}, 0);
  jet.set(Vec3::Zero(), {-1, 0, 0}, -1e5);
  EXPECT_LT((jet.velocity({5, 0.4, 0}, 0) + ahead).norm(), 1e-15);
  EXPECT_EQ(jet.velocity({-5, 0.4, 0}, 0), Vec3::Zero());
  EXPECT_FALSE(jet.acts_on_vessel());
}

}  // namespace propeller_jet_test

}  // namespace nilas::hydro
