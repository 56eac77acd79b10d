#pragma once
/// Bodies for tests of the detector.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/base/random.h"
#include "core/bodies/bodies.h"
#include "core/geometry/shape.h"
#include "tests/support/about_centroid.h"

namespace nilas::detect {

inline int add_body(bodies::Bodies& bodies, const geometry::Shape& shape, const Vec3& p,
                    const Quat& q = Quat::Identity(), bodies::Motion motion = bodies::Motion::free) {
  bodies::BodySpec spec;
  spec.name = "body" + std::to_string(bodies.size());
  spec.motion = motion;
  spec.shape = std::make_shared<const geometry::Shape>(shape);
  spec.mass = 1;
  spec.pose = {q, p};
  return bodies.add(spec);
}

inline std::vector<Vec2> regular_outline(int corners, double radius, double turn = 0) {
  std::vector<Vec2> outline;
  for (int k = 0; k < corners; ++k) {
    const double angle = turn + 2 * k_pi * k / corners;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

/// A convex outline of 4 to 10 corners on a circle of the given radius.
inline std::vector<Vec2> random_outline(RandomStream& random, double radius) {
  const int corners = 4 + static_cast<int>(random.uniform(0, 7));
  std::vector<Vec2> outline;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * k_pi * (k + random.uniform(-0.4, 0.4)) / corners;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

/// A floe with its centroid at the origin, as prism_shape requires.
inline geometry::Shape floe_shape(const std::vector<Vec2>& outline, double thickness) {
  return geometry::prism_shape(test::about_centroid(outline), thickness);
}

/// A random attitude: any yaw, tilted by about `tilt` [rad].
inline Quat random_tilt(RandomStream& random, double tilt) {
  const Vec3 axis(random.normal(), random.normal(), 0);
  const double yaw = random.uniform(0, 2 * k_pi);
  return Quat(Eigen::AngleAxisd(yaw, Vec3::UnitZ())) *
         Quat(Eigen::AngleAxisd(random.uniform(0, tilt), axis.normalized()));
}

}  // namespace nilas::detect
