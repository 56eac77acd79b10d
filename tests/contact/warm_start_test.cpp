/// Tests of the last step's impulses as the next step's guess.
#include "contact/warm_start.h"

#include <gtest/gtest.h>

#include "contact/law/contact_frame.h"

namespace nilas::contact {
namespace warm_start_test {

constexpr std::uint64_t k_key = 7;

/// The body tilts until another of its axes determines the tangents. The impulse keeps its direction.
TEST(WarmStart, KeepsAnImpulseWhereItPointsThoughTheTangentsTurn) {
  const Vec3 n = Vec3(1, 0.02, -0.01).normalized();
  const Mat3 upright = Mat3::Identity();
  const Mat3 tilted = Eigen::AngleAxisd(0.2, Vec3::UnitY()).toRotationMatrix();
  const Mat3 before = contact_frame(n, upright, 0), after = contact_frame(n, tilted, 0);
  ASSERT_LT(before.col(1).dot(after.col(1)), 0.5) << "the same axis still: nothing is tested";
  WarmStart warm;
  const Vec3 impulse(3, 0.5, -0.25);
  warm.keep({k_key}, {before}, impulse);
  const VecX guess = warm.guess({k_key}, {after});
  EXPECT_LT((after * guess - before * impulse).norm(), 1e-14);
  EXPECT_NEAR(guess[0], 3, 1e-14);
}

TEST(WarmStart, GivesNothingToNewContacts) {
  WarmStart warm;
  warm.keep({k_key, k_key + 1}, {Mat3::Identity(), Mat3::Identity()}, VecX::Ones(6));
  const VecX guess = warm.guess({k_key + 2, k_key}, {Mat3::Identity(), Mat3::Identity()});
  EXPECT_TRUE(guess.head<3>().isZero(0));
  EXPECT_EQ(Vec3(guess.tail<3>()), Vec3::Ones());
}

/// Mirrored frames may have other signs. The guess is still the mirrored impulse, to the last bit.
TEST(WarmStart, MirroredContactsGetMirroredGuesses) {
  const Vec3 signs(1, -1, 1);
  const auto image = [&](const Mat3& R) -> Mat3 { return signs.asDiagonal() * R * signs.asDiagonal(); };
  const Vec3 n = Vec3(0.9, 0.3, -0.2).normalized();
  const Mat3 upright = Eigen::AngleAxisd(0.3, Vec3::UnitZ()).toRotationMatrix();
  const Mat3 tilted = Eigen::AngleAxisd(0.7, Vec3(1, 1, 0).normalized()).toRotationMatrix();
  const Vec3 pressed(0.4, 0.1, -0.3);  // in G
  const auto guess_in_g = [&](const Vec3& normal, const Mat3& one, const Mat3& two, const Vec3& impulse) -> Vec3 {
    const Mat3 before = contact_frame(normal, one, 0), after = contact_frame(normal, two, 0);
    WarmStart warm;
    warm.keep({k_key}, {before}, before.transpose() * impulse);
    return after * warm.guess({k_key}, {after});
  };
  EXPECT_EQ(guess_in_g(signs.cwiseProduct(n), image(upright), image(tilted), signs.cwiseProduct(pressed)),
            Vec3(signs.cwiseProduct(guess_in_g(n, upright, tilted, pressed))));
}

}  // namespace warm_start_test
}  // namespace nilas::contact
