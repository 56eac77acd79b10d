#include "core/output/loads/twin_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/output/sample_run.h"

namespace nilas::output {
namespace twin_statistics_test {

/// The sample's one free body has a bounding radius of 0: give it one.
bodies::Bodies one_metre_across() {
  bodies::Bodies bodies = test::sample_bodies();
  geometry::Shape shape = test::triangle_floe();
  shape.bounding_radius = 0.5;
  bodies.shape[0] = std::make_shared<const geometry::Shape>(shape);
  return bodies;
}

TEST(TwinHorizon, IsWhereAnExponentialPassesTheThreshold) {
  const bodies::Bodies itself = one_metre_across();
  TwinHorizon horizon(itself);
  EXPECT_DOUBLE_EQ(horizon.threshold(), 1e-4);
  for (int k = 1; k <= 1000; ++k) {
    bodies::Bodies twin = itself;
    const double t = 0.01 * k;
    twin.p_GB[0].y() += 1e-12 * std::exp(t / 0.2);
    horizon.compare(t, {&itself, &twin});
  }
  EXPECT_NEAR(horizon.horizon().value(), 0.2 * std::log(1e8), 0.01);
  EXPECT_NEAR(horizon.e_folding().value(), 0.2, 1e-4);
}

TEST(TwinHorizon, NeverReachedWhereTwinsStayTogether) {
  const bodies::Bodies itself = one_metre_across();
  bodies::Bodies twin = itself;
  twin.p_GB[0].x() += 1e-12;
  TwinHorizon horizon(itself);
  for (int k = 1; k <= 100; ++k) horizon.compare(0.01 * k, {&itself, &twin});
  EXPECT_FALSE(horizon.horizon().has_value());
  EXPECT_FALSE(horizon.e_folding().has_value());
}

TEST(TwinHorizon, EndsWhereTheBodiesAreNotTheSameAnyMore) {
  const bodies::Bodies itself = one_metre_across();
  bodies::Bodies twin = itself;
  TwinHorizon horizon(itself);
  horizon.compare(0.01, {&itself, &twin});
  twin.id[0] = 77;
  horizon.compare(0.02, {&itself, &twin});
  horizon.compare(0.03, {&itself, &twin});
  EXPECT_EQ(horizon.horizon().value(), 0.02);
}

}  // namespace twin_statistics_test
}  // namespace nilas::output
