#include "fracture/bend/resistance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/math.h"

namespace nilas::fracture {

namespace resistance_test {

IcebreakingHull hull() { return {100, 20, 7, 30 * k_deg, 30 * k_deg}; }
LevelIce ice() { return {0.8, 5e5, 2e9, 0.3, 920, 1025, 0.1, 9.81}; }

/// L 100, B 20, T 7, phi = alpha = 30 deg, mu 0.1, sigma 0.5 MPa, h 0.8, E 2 GPa, by hand to the newton.
TEST(Resistance, Lindqvist) {
  const LindqvistResistance r = lindqvist_resistance(hull(), ice(), 2);
  EXPECT_NEAR(r.crushing, 122931, 1);
  EXPECT_NEAR(r.bending, 80237, 1);
  EXPECT_NEAR(r.submersion, 190030, 1);
  EXPECT_NEAR(r.total, 710325, 1);
  EXPECT_NEAR(lindqvist_resistance(hull(), ice(), 0).total, 393198, 1);
}

TEST(Resistance, PowersOfLindqvist) {
  const LindqvistResistance r = lindqvist_resistance(hull(), ice(), 0);
  LevelIce thick = ice(), strong = ice();
  thick.thickness *= 2;
  strong.flexural_strength *= 2;
  const LindqvistResistance t = lindqvist_resistance(hull(), thick, 0), s = lindqvist_resistance(hull(), strong, 0);
  EXPECT_NEAR(t.crushing / r.crushing, 4, 1e-12);
  EXPECT_NEAR(t.bending / r.bending, std::pow(2, 1.5), 1e-12);
  EXPECT_NEAR(t.submersion / r.submersion, 2, 1e-12);
  EXPECT_NEAR(s.crushing / r.crushing, 2, 1e-12);
  EXPECT_NEAR(s.bending / r.bending, 2, 1e-12);
  EXPECT_EQ(s.submersion, r.submersion);
}

/// Computed by hand: B 20 m, h 0.8 m, 1 m/s, nine tenths.
TEST(Resistance, Zuev) {
  EXPECT_NEAR(zuev_resistance(20, ice(), 0.9, 1), 388847.06, 0.01);
  EXPECT_EQ(zuev_resistance(20, ice(), 0, 1), 0);
  EXPECT_GT(zuev_resistance(20, ice(), 0.9, 2), zuev_resistance(20, ice(), 0.9, 1));
  // At rest only 0.13 B h rho_i g remains: linear in h.
  LevelIce thick = ice();
  thick.thickness *= 2;
  EXPECT_NEAR(zuev_resistance(20, thick, 0.9, 0) / zuev_resistance(20, ice(), 0.9, 0), 2, 1e-12);
}

TEST(Resistance, RefusesImpossibleInput) {
  LevelIce heavy = ice(), rough = ice();
  heavy.density = 1100;
  rough.friction = 1.5;
  EXPECT_THROW(lindqvist_resistance(hull(), heavy, 0), ContractError);
  EXPECT_THROW(lindqvist_resistance(hull(), rough, 0), ContractError);
  EXPECT_THROW(lindqvist_resistance({100, 20, 7, 0, 0.5}, ice(), 0), ContractError);
  EXPECT_THROW(zuev_resistance(20, ice(), 1.1, 0), ContractError);
}

}  // namespace resistance_test
}  // namespace nilas::fracture
