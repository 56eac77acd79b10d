/// Tests of FCL's direction, which is queried in the pair's own scale.
#include "contact/detect/search/fcl_query.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/contact/detect/bodies_of_tests.h"

namespace nilas::detect {
namespace fcl_query_test {

/// A box with its top at z = 0 and a body `gap` above it. All sizes are multiplied by `scale`, far from the origin.
struct Stack {
  bodies::Bodies bodies;
  std::vector<Part> parts;

  Stack(const geometry::Shape& upper, double reach, double scale, double gap) {
    const Vec3 origin(1e3, -2e3, 5e2);
    add_body(bodies, geometry::box_shape(scale * Vec3(3, 3, 1)), origin - Vec3(0, 0, 0.5 * scale));
    add_body(bodies, upper, origin + Vec3(0.1 * scale, 0.2 * scale, reach + gap));
    for (int b : {0, 1})
      for (Part& part : make_parts(bodies, b)) parts.push_back(std::move(part));
  }
  PairView pair() const { return view_pair(parts[0], parts[1], pose_of_b_in_a(bodies, 0, 1), 1); }
};

TEST(FclQuery, FindsTheDirectionAtAnyScaleApartAndOverlapping) {
  for (double scale : {1e-4, 1e-2, 1.0, 1e3})
    for (double gap : {0.01 * scale, -0.01 * scale})
      for (const bool cylinder : {false, true}) {
        const geometry::Shape upper =
            cylinder ? geometry::cylinder_shape(0.5 * scale, scale) : geometry::box_shape(scale * Vec3(1, 1, 1));
        const Stack stack(upper, 0.5 * scale, scale, gap);
        FclShapes fcl;
        const auto direction = fcl.direction(stack.pair(), gap > 0);
        ASSERT_TRUE(direction) << scale << " " << gap;
        EXPECT_NEAR((*direction - Vec3::UnitZ()).norm(), 0, 1e-4) << scale << " " << gap << " " << cylinder;
      }
}

TEST(FclQuery, AWrongGuessOfOverlapIsPutRight) {
  const Stack stack(geometry::box_shape({1, 1, 1}), 0.5, 1, 0.01);
  FclShapes fcl;
  const auto direction = fcl.direction(stack.pair(), false);
  ASSERT_TRUE(direction);
  EXPECT_NEAR((*direction - Vec3::UnitZ()).norm(), 0, 1e-6);
}

}  // namespace fcl_query_test
}  // namespace nilas::detect
