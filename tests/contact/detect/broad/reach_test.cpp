#include "contact/detect/broad/reach.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "contact/detect/detector.h"
#include "tests/contact/detect/bodies_of_tests.h"

namespace nilas::detect {
namespace reach_test {

constexpr double k_step = 0.01;

/// Unit cubes in a row along x with these gaps between them.
bodies::Bodies row_of_cubes(const std::vector<double>& gaps) {
  bodies::Bodies bodies;
  double x = 0;
  const geometry::Shape cube = floe_shape({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
  add_body(bodies, cube, Vec3(x, 0, 0));
  for (const double gap : gaps) add_body(bodies, cube, Vec3(x += 1 + gap, 0, 0));
  return bodies;
}

std::set<std::pair<int, int>> touching(const std::vector<ContactPoint>& points) {
  std::set<std::pair<int, int>> pairs;
  for (const auto& c : points) pairs.emplace(c.a, c.b);
  return pairs;
}

TEST(Reach, OfAFreeBodyIsItsWayRelativeToTheMeanOfAll) {
  bodies::Bodies bodies = row_of_cubes({1, 1});
  bodies.v_GB[0] = Vec3(0.6, 0, 0);
  bodies.w_GB[1] = Vec3(0, 0, 2);
  const auto reach = own_reach(bodies, bodies::Wrenches(3), k_step, 1.5);
  EXPECT_NEAR(reach[0], 1.5 * k_step * 0.4, 1e-15);
  EXPECT_NEAR(reach[1], 1.5 * k_step * (0.2 + 2 * bodies.shape[1]->bounding_radius), 1e-15);
  EXPECT_NEAR(reach[2], 1.5 * k_step * 0.2, 1e-15);
}

TEST(Reach, LoadsOfFreeBodiesCountAndFixedOnesReachNothing) {
  bodies::Bodies bodies = row_of_cubes({1});
  add_body(bodies, *bodies.shape[0], Vec3(9, 0, 0), Quat::Identity(), bodies::Motion::fixed);
  bodies::Wrenches loads(3);
  loads[0].force = Vec3(0, 0, 5);
  loads[1].torque = Vec3(0, 0, 7);
  const auto reach = own_reach(bodies, loads, k_step, 1.5);
  const double spin = k_step * 7 * bodies.inertia_inverse_B[1](2, 2);
  EXPECT_NEAR(reach[0], 1.5 * k_step * k_step * 5 / bodies.mass[0], 1e-15);
  EXPECT_NEAR(reach[1], 1.5 * k_step * spin * bodies.shape[1]->bounding_radius, 1e-12);
  EXPECT_EQ(reach[2], 0);
}

TEST(Reach, IsHandedAlongAChainWithTheCommonSpeedLessTheGaps) {
  const bodies::Bodies bodies = row_of_cubes({1e-3, 1e-3, 1e-3});
  // 8 mm by itself; then (8 - 1)/2 = 3.5 mm and (3.5 - 1)/2 = 1.25 mm, so the third gap still closes
  ContactDetector detector;
  EXPECT_EQ(touching(detector.detect(bodies, {8e-3, 0, 0, 0})).size(), 3u);
  // 5 mm: 2 mm, then 0.5 mm, and the third gap stays open
  EXPECT_EQ(touching(detector.detect(bodies, {5e-3, 0, 0, 0})), (std::set<std::pair<int, int>>{{0, 1}, {1, 2}}));
}

TEST(Reach, MarginsOfPairsLoseNoPairAndNoGap) {
  RandomStream random(5, "reach");
  bodies::Bodies bodies;
  for (int k = 0; k < 60; ++k)
    add_body(bodies, floe_shape(random_outline(random, 0.5), 0.1),
             Vec3(random.uniform(0, 7), random.uniform(0, 7), random.uniform(-0.02, 0.02)), random_tilt(random, 0.02));
  std::vector<double> own;
  for (int k = 0; k < bodies.size(); ++k) own.push_back(k % 7 == 0 ? 0.1 : 0.002 * random.uniform(0, 1));
  ContactDetector wide, narrow;
  std::vector<ContactPoint> all = wide.detect(bodies, 0.2);
  drop_out_of_reach(bodies, own, all);
  const std::vector<ContactPoint> some = narrow.detect(bodies, own);
  EXPECT_EQ(touching(all), touching(some));
  const auto deepest = [](const std::vector<ContactPoint>& points) {
    std::map<std::pair<int, int>, double> least;
    for (const auto& c : points) {
      auto [place, fresh] = least.try_emplace({c.a, c.b}, c.gap);
      if (!fresh) place->second = std::min(place->second, c.gap);
    }
    return least;
  };
  const auto one = deepest(all), other = deepest(some);
  EXPECT_GT(one.size(), 60u);
  for (const auto& [pair, gap] : one) EXPECT_NEAR(other.at(pair), gap, 1e-12);
}

}  // namespace reach_test
}  // namespace nilas::detect
