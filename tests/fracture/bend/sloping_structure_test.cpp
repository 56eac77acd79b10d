#include "fracture/bend/sloping_structure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/math.h"

namespace nilas::fracture {

namespace sloping_structure_test {

const SlopingStructure k_slope{10, 45 * k_deg, true};
const LevelIce k_ice{1, 5e5, 5e9, 0.3, 920, 1025, 0.1, 9.81};
const Rubble k_rubble{4, 30 * k_deg, 0.3, 5e3, 40 * k_deg, 0.1};

/// w 10 m, alpha 45 deg, mu 0.1, sigma 0.5 MPa, h 1 m, E 5 GPa: H_B 0.7205 MN; the other parts by a second computation
/// of the same formulas.
TEST(SlopingStructure, Croasdale) {
  const SlopeLoad load = croasdale_load(k_slope, k_ice, k_rubble);
  EXPECT_NEAR(load.breaking, 720533.62, 0.01);
  EXPECT_NEAR(load.push_through, 15637.48, 0.01);
  EXPECT_NEAR(load.ride_up, 674940.59, 0.01);
  EXPECT_NEAR(load.lifting, 387030.31, 0.01);
  EXPECT_NEAR(load.turning, 150420.00, 0.01);
  EXPECT_NEAR(load.total, 2011518.23, 0.01);
}

/// H_B ~ sigma h^(5/4) w without edge cracks; with them l_c = 46.04 m takes the place of w = 10 m.
TEST(SlopingStructure, PowersOfCroasdale) {
  SlopingStructure plain = k_slope;
  plain.edge_cracks = false;
  LevelIce thick = k_ice, strong = k_ice;
  thick.thickness *= 2;
  strong.flexural_strength *= 2;
  const double breaking = croasdale_load(plain, k_ice, k_rubble).breaking;
  EXPECT_NEAR(croasdale_load(plain, thick, k_rubble).breaking / breaking, std::pow(2, 1.25), 1e-12);
  EXPECT_NEAR(croasdale_load(plain, strong, k_rubble).breaking / breaking, 2, 1e-12);
  EXPECT_NEAR(croasdale_load(k_slope, k_ice, k_rubble).breaking / breaking, 4.604, 5e-4);
}

/// There is no rubble to push through, lift or carry.
TEST(SlopingStructure, CleanSlope) {
  Rubble none = k_rubble;
  none.height = 0;
  const SlopeLoad load = croasdale_load(k_slope, k_ice, none);
  EXPECT_EQ(load.push_through + load.ride_up + load.lifting, 0);
}

/// D 10 m, D_T 4 m, 45 deg, mu 0.1; elliptic integrals by the midpoint rule in a second computation.
TEST(SlopingStructure, Ralston) {
  const RalstonLoad load = ralston_load(k_slope, 4, 1, k_ice);
  EXPECT_NEAR(load.breaking, 1262757.19, 0.01);
  EXPECT_NEAR(load.ride_up, 341212.37, 0.01);
}

/// The ride-up without friction is the weight W times tan a.
TEST(SlopingStructure, FrictionlessRalston) {
  LevelIce smooth = k_ice;
  smooth.friction = 0;
  const RalstonLoad load = ralston_load(k_slope, 4, 1, smooth);
  EXPECT_NEAR(load.ride_up, 920 * 9.81 * 84 / (4 * std::cos(45 * k_deg)), 1e-6 * load.ride_up);
  EXPECT_LT(load.breaking, ralston_load(k_slope, 4, 1, k_ice).breaking);
  EXPECT_NEAR(ralston_load(k_slope, 4, 2, smooth).ride_up / load.ride_up, 2, 1e-12);
}

TEST(SlopingStructure, RefusesImpossibleInput) {
  LevelIce rough = k_ice, soft = k_ice;
  rough.friction = 1;
  soft.youngs_modulus = 1e3;
  EXPECT_THROW(croasdale_load(k_slope, rough, k_rubble), ContractError);
  EXPECT_THROW(croasdale_load(k_slope, soft, k_rubble), ContractError);
  EXPECT_THROW(croasdale_load({10, 20 * k_deg, true}, k_ice, k_rubble), ContractError);
  EXPECT_THROW(ralston_load(k_slope, 12, 1, k_ice), ContractError);
  EXPECT_THROW(ralston_load({10, 80 * k_deg, true}, 4, 1, rough), ContractError);
}

}  // namespace sloping_structure_test
}  // namespace nilas::fracture
