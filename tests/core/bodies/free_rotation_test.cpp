/// The exponential map; the conservation of turn_freely() is tested on bodies (tests/core/sim/advance_test.cpp) and on
/// the vessel (tests/core/vessel/vessel_moreau_free_test.cpp).
#include "core/bodies/free_rotation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace free_rotation_test {

using namespace nilas;
using namespace nilas::bodies;

TEST(Exponential, TurnsByTheVectorsLength) {
  const Vec3 axis = Vec3(1, 2, -2) / 3;
  for (const double angle : {1e-9, 1e-5, 0.3, 3.0}) {
    const Quat q = exponential(angle * axis);
    EXPECT_NEAR(q.norm(), 1, 1e-15);
    EXPECT_NEAR(2 * std::atan2(q.vec().norm(), q.w()), angle, 1e-15 + 1e-15 * angle);
  }
}

/// Backwards with the reversed spin the body returns to where it was.
TEST(FreeRotation, IsItsOwnImageInTime) {
  const Mat3 inertia = Vec3(1, 2, 2.5).asDiagonal();
  const Quat start(0.5, 0.5, -0.5, 0.5);
  const Vec3 spin(0.4, 2, 0.3);
  Quat q = start;
  Vec3 w = spin;
  for (int k = 0; k < 100; ++k) turn_freely(q, w, inertia, inertia.inverse(), 0.1);
  w = -w;
  for (int k = 0; k < 100; ++k) turn_freely(q, w, inertia, inertia.inverse(), 0.1);
  EXPECT_LT(q.angularDistance(start), 1e-12);
  EXPECT_LT((w + spin).norm(), 1e-12);
}

}  // namespace free_rotation_test
