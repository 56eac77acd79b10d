/// Tests of the pressure of crushing ice and its memory.
#include "fracture/crush/crushing_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fracture/crush/crushed_depth.h"

namespace nilas::fracture {
namespace crushing_law_test {

TEST(CrushingLaw, PressureByModel) {
  const CrushingLaw seed{CrushingModel::explicit_area, 7.4e6, -0.7, 2e5};
  EXPECT_EQ(seed.pressure(3e5, 0.01), 3e5);
  EXPECT_FALSE(seed.is_implicit());
  EXPECT_EQ((CrushingLaw{CrushingModel::compliant, 7.4e6, -0.7, 2e5}.pressure(3e5, 0.01)), 3e5);
  const CrushingLaw iso{CrushingModel::pressure_area, 7.4e6, -0.7, 2e5};
  EXPECT_NEAR(iso.pressure(2e5, 1), 7.4e6, 1e-6) << "on 1 m^2 the pressure is the coefficient";
  EXPECT_NEAR(iso.pressure(2e5, 10), 7.4e6 / std::pow(10, 0.7), 1e-6);
  EXPECT_NEAR(iso.pressure(4e5, 10), 2 * iso.pressure(2e5, 10), 1e-6) << "in the ratio of the strengths";
  EXPECT_EQ(iso.pressure(2e5, 0), 0);
  EXPECT_TRUE(iso.is_implicit());
}

const CrushedFace k_face{1, 2, 3, 0};

TEST(CrushedDepth, KeepsTheDeepestPlane) {
  CrushedDepth crushed;
  const Vec3 n = Vec3::UnitX();
  for (const double x : {0.1, 0.3, 0.2}) {
    const CrushedPlane plane = crushed.advance(k_face, n, Vec3(x, 1, 0), 1);
    crushed.forget_others();
    EXPECT_DOUBLE_EQ(plane.offset, x == 0.1 ? 0.1 : 0.3);
    EXPECT_DOUBLE_EQ(plane.gap(Vec3(x, -1, 0)), x == 0.2 ? 0.3 - 0.2 : 0);
  }
  crushed.forget_others();  // the face has left
  EXPECT_DOUBLE_EQ(crushed.advance(k_face, n, Vec3(0.2, 0, 0), 1).offset, 0.2);
}

/// Ice next to crushed ice is intact.
TEST(CrushedDepth, IsForgottenWhereTheFaceGoesAlong) {
  for (const double along : {0.19, 0.21}) {
    CrushedDepth crushed;
    crushed.advance(k_face, Vec3::UnitX(), Vec3(0.3, 0, 0), 0.2);
    crushed.forget_others();
    EXPECT_EQ(crushed.advance(k_face, Vec3::UnitX(), Vec3(0.2, along, 0), 0.2).offset, along < 0.2 ? 0.3 : 0.2);
  }
}

/// Two parts of the floe, of three of the piece: each knows the deeper of both planes, in the piece's frame.
TEST(CrushedDepth, IsHandedOnToPieces) {
  CrushedDepth crushed;
  const Vec3 n = Vec3(0.6, 0, 0.8);
  for (const auto& [part, x] : {std::pair(0, 0.5), std::pair(1, 0.3)})
    crushed.advance({1, 2, 3, part}, n, Vec3(x, 0, 0), 1);
  crushed.advance({1, 7, 3, 0}, n, Vec3(9, 0, 0), 1);
  crushed.forget_others();
  crushed.hand_on(2, 4, {0.2, 0.7}, 3);
  for (const int part : {0, 1, 2}) {
    const CrushedPlane plane = crushed.advance({1, 4, 3, part}, n, Vec3(0.1, 0, 0), 1);
    EXPECT_NEAR(plane.gap(Vec3(0.1, 0, 0)), 0.6 * (0.5 - 0.2 - 0.1), 1e-15);
    EXPECT_EQ(plane.normal, n);
  }
  EXPECT_EQ(crushed.advance({1, 4, 2, 0}, n, Vec3(0.1, 0, 0), 1).gap(Vec3(0.1, 0, 0)), 0) << "another face";
}

TEST(CrushedDepth, GoesOnFromItsState) {
  CrushedDepth crushed, other;
  crushed.advance(k_face, Vec3::UnitX(), Vec3(0.3, 0, 0), 1);
  crushed.forget_others();
  State state;
  crushed.save(StateWriter(state));
  other.restore(StateReader(state));
  EXPECT_EQ(other.advance(k_face, Vec3::UnitX(), Vec3(0.2, 0, 0), 1).offset, 0.3);
}

}  // namespace crushing_law_test
}  // namespace nilas::fracture
