#include "core/vessel/control/reference_filter.h"

#include <gtest/gtest.h>

namespace reference_filter_test {

using namespace nilas;
using vessel::ReferenceFilter;

const Vec3 k_bandwidth(0.1, 0.2, 0.5);

// A jump from rest: 1 - exp(-w t) (1 + w t + (w t)^2 / 2), and its derivatives.
TEST(ReferenceFilter, FollowsAJumpWithCriticalDamping) {
  ReferenceFilter filter(k_bandwidth, Vec3::Zero());
  double t = 0;
  for (const double h : {0.3, 4.0, 0.01, 11.0, 2.5}) {
    filter.advance(Vec3(5, -2, 1), Vec3::Zero(), h);
    t += h;
    for (int k = 0; k < 3; ++k) {
      const double size = Vec3(5, -2, 1)[k], w = k_bandwidth[k], wt = w * t, decay = std::exp(-wt);
      EXPECT_NEAR(filter.position()[k], size * (1 - decay * (1 + wt + wt * wt / 2)), 1e-13);
      EXPECT_NEAR(filter.velocity()[k], size * w * decay * wt * wt / 2, 1e-13);
      EXPECT_NEAR(filter.acceleration()[k], size * w * w * decay * (wt - wt * wt / 2), 1e-13);
    }
  }
}

TEST(ReferenceFilter, NeverOvershootsAJump) {
  ReferenceFilter filter(k_bandwidth, Vec3::Zero());
  double before = 0;
  for (int k = 0; k < 3000; ++k) {
    filter.advance(Vec3::Ones(), Vec3::Zero(), 0.1);
    EXPECT_GE(filter.position().x(), before);
    EXPECT_LE(filter.position().x(), 1);
    before = filter.position().x();
  }
  EXPECT_NEAR(before, 1, 1e-9);
}

// Along a steady motion the rate of the target takes the lag away. The target of each step is its value at the end, so
// the error is about half a step of the motion.
TEST(ReferenceFilter, DoesNotLagBehindASteadyMotion) {
  ReferenceFilter filter(k_bandwidth, Vec3::Zero());
  constexpr double k_step = 0.01, k_speed = 0.5;
  double t = 0;
  for (int k = 0; k < 20000; ++k) {
    t += k_step;
    filter.advance(Vec3(k_speed * t, 0, 0), Vec3(k_speed, 0, 0), k_step);
  }
  EXPECT_NEAR(filter.position().x(), k_speed * t, k_speed * k_step);
  EXPECT_NEAR(filter.velocity().x(), k_speed, 1e-4);
}

}  // namespace reference_filter_test
