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

/// A body of anisotropic mass, whose water couples sway with yaw, in a flow: seen from the flow, its momenta about a
/// fixed point and its energy are kept over many steps of any size.
TEST(FreeMotion, KeepsMomentaAndEnergyOfBodyAndWater) {
  Mat6 mass = Mat6::Zero();
  mass.diagonal() << 10, 25, 60, 4, 9, 7;
  mass(1, 5) = mass(5, 1) = 3;
  const Mat6 inverse = mass.inverse();
  const Vec3 flow(0.2, -0.3, 0.1);
  for (const double h : {0.01, 0.1, 0.4}) {
    Vec3 p(1, 2, 3), v(1.2, 0.4, -0.3), w(0.5, -0.8, 1.1);
    Quat q(0.5, 0.5, -0.5, 0.5);
    double t = 0;
    const auto kept = [&] {
      const Mat3 R = q.toRotationMatrix();
      Vec6 twist;
      twist << R.transpose() * (v - flow), R.transpose() * w;
      const Vec6 momentum = mass * twist;
      const Vec3 linear = R * momentum.head<3>(), at = p - t * flow;
      Eigen::Matrix<double, 7, 1> all;
      all << linear, R * momentum.tail<3>() + at.cross(linear), twist.dot(momentum);
      return all;
    };
    const auto start = kept();
    for (int k = 0; k < 500; ++k) {
      move_freely(p, q, v, w, mass, inverse, flow, h);
      t += h;
    }
    EXPECT_LT((kept() - start).cwiseAbs().maxCoeff(), 1e-11 * start.norm()) << h;
  }
}

/// Without water the motion is that of turn_freely() and a straight path; backwards it returns.
TEST(FreeMotion, OfABodyAloneIsThatOfTheBody) {
  Mat6 mass = Mat6::Zero();
  mass.diagonal() << 10, 10, 10, 4, 9, 7;
  const Mat3 inertia = Vec3(4, 9, 7).asDiagonal();
  Vec3 p(0, 0, 0), v(1, -2, 0.5), w(0.4, 1.5, 0.2), spin = w;
  Quat q = Quat::Identity(), turned = q;
  move_freely(p, q, v, w, mass, mass.inverse(), Vec3::Zero(), 0.1);
  turn_freely(turned, spin, inertia, inertia.inverse(), 0.1);
  EXPECT_LT((p - 0.1 * Vec3(1, -2, 0.5)).norm(), 1e-15);
  EXPECT_LT((v - Vec3(1, -2, 0.5)).norm(), 1e-14);
  EXPECT_LT((w - spin).norm(), 1e-14);
  EXPECT_LT(q.angularDistance(turned), 1e-14);
  v = -v;
  w = -w;
  move_freely(p, q, v, w, mass, mass.inverse(), Vec3::Zero(), 0.1);
  EXPECT_LT(p.norm() + q.angularDistance(Quat::Identity()), 1e-14);
}

}  // namespace free_rotation_test
