#pragma once
/// A crowd of drifting floes, and exact comparison of contact points.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "contact/detect/broad/contact_point.h"
#include "tests/contact/detect/bodies_of_tests.h"

namespace nilas::detect {

struct FloeSpec {
  geometry::Shape shape;
  Vec3 p;
  Quat q;
};

/// A crowd of floes in a square, many of them touching.
inline std::vector<FloeSpec> crowd(int count, std::uint64_t seed) {
  RandomStream random(seed, "crowd");
  const double side = 0.9 * std::sqrt(count);
  std::vector<FloeSpec> floes;
  for (int k = 0; k < count; ++k)
    floes.push_back({floe_shape(random_outline(random, 0.5), 0.1),
                     Vec3(random.uniform(0, side), random.uniform(0, side), random.uniform(-0.02, 0.02)),
                     random_tilt(random, 0.02)});
  return floes;
}

inline bodies::Bodies bodies_of(const std::vector<FloeSpec>& floes, const std::vector<int>& order) {
  bodies::Bodies bodies;
  for (int k : order) {
    const int b = add_body(bodies, floes[k].shape, floes[k].p, floes[k].q);
    bodies.name[b] = std::to_string(k);
  }
  return bodies;
}

inline std::vector<int> in_order(std::size_t count) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// Moves every body a little, each along a path of its own.
inline void drift(bodies::Bodies& bodies, int step) {
  for (int b = 0; b < bodies.size(); ++b) {
    const double phase = 0.7 * b + 0.05 * step;
    const Quat turn(Eigen::AngleAxisd(2e-3 * std::sin(phase), Vec3(0.1, 0.2, 1).normalized()));
    bodies.set_pose(b, bodies.p_GB[b] + 3e-3 * Vec3(std::cos(phase), std::sin(1.3 * phase), 0.1 * std::sin(phase)),
                    turn * bodies.q_GB[b]);
  }
}

inline void expect_same_bits(const std::vector<ContactPoint>& one, const std::vector<ContactPoint>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].key, other[i].key);
    EXPECT_EQ(one[i].p, other[i].p);
    EXPECT_EQ(one[i].n, other[i].n);
    EXPECT_EQ(one[i].gap, other[i].gap);
  }
}

}  // namespace nilas::detect
