/// The search for fast pairs finds what a look at every pair finds, however the bodies are spread.
#include "contact/detect/broad/fast_pairs.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "tests/contact/detect/bodies_of_tests.h"

namespace fast_pairs_test {

using namespace nilas;
using namespace nilas::detect;

constexpr double k_share = 0.5, k_step = 0.1;

struct Moving {
  bodies::Bodies bodies;
  std::vector<Vec3> v, w;
};

/// Floes in a box of these sides [m], each about 1 m wide and 0.1 m thick. All drift; one in `one_in` is also fast, one
/// in seven turns and one in eleven is fixed. A long wall lies beside them.
Moving crowd(const Vec3& sides, int count, int one_in, std::uint64_t seed) {
  RandomStream random(seed, "fast pairs");
  const auto anywhere = [&] { return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)); };
  Moving crowd;
  const auto add = [&](const geometry::Shape& shape, const Vec3& p, const Vec3& v, const Vec3& w, bodies::Motion how) {
    add_body(crowd.bodies, shape, p, random_tilt(random, 0.1), how);
    crowd.v.push_back(v);
    crowd.w.push_back(w);
  };
  for (int k = 0; k < count; ++k)
    add(floe_shape(random_outline(random, 0.5), 0.1), 0.5 * sides.cwiseProduct(anywhere()),
        Vec3(0.3, -0.2, 0) + (k % one_in == 0 ? 3.0 : 0.01) * anywhere(), k % 7 == 0 ? anywhere() : Vec3::Zero(),
        k % 11 == 0 ? bodies::Motion::fixed : bodies::Motion::free);
  add(geometry::box_shape(sides.cwiseMax(0.2)), Vec3(0, sides.y(), 0), Vec3::Zero(), Vec3::Zero(),
      bodies::Motion::fixed);
  return crowd;
}

using Pairs = std::set<std::pair<int, int>>;

/// Whether the balls around two bodies meet along paths that are straight and cut into many places.
bool balls_meet(const Moving& crowd, int a, int b) {
  const auto way = [&](int k) {
    return crowd.bodies.motion[k] == bodies::Motion::fixed ? Vec3(Vec3::Zero()) : Vec3(k_step * crowd.v[k]);
  };
  const Vec3 apart = crowd.bodies.p_GB[b] - crowd.bodies.p_GB[a], relative = way(b) - way(a);
  const double reach = crowd.bodies.shape[a]->bounding_radius + crowd.bodies.shape[b]->bounding_radius;
  for (int k = 0; k <= 20; ++k)
    if ((apart + k / 20.0 * relative).norm() <= reach) return true;
  return false;
}

/// The search's pairs; those that a look at every pair finds must be among them, and no slow one.
Pairs expect_complete(const Moving& crowd) {
  const FastMotion motion{crowd.v, crowd.w, k_step};
  const std::vector<double> widths = smallest_widths(crowd.bodies);
  Pairs found;
  for (const FastPair& pair : fast_pairs(crowd.bodies, motion, widths, k_share)) {
    EXPECT_LT(pair.a, pair.b);
    EXPECT_TRUE(is_fast(crowd.bodies, motion, widths, k_share, pair.a, pair.b));
    EXPECT_TRUE(found.emplace(pair.a, pair.b).second) << "twice";
  }
  for (int a = 0; a < crowd.bodies.size(); ++a)
    for (int b = a + 1; b < crowd.bodies.size(); ++b) {
      if (crowd.bodies.motion[a] == bodies::Motion::fixed && crowd.bodies.motion[b] == bodies::Motion::fixed) continue;
      if (is_fast(crowd.bodies, motion, widths, k_share, a, b) && balls_meet(crowd, a, b)) {
        EXPECT_TRUE(found.contains({a, b})) << a << " and " << b << " are missing";
      }
    }
  return found;
}

TEST(FastPairs, AreCompleteAmongFewAndManyFastBodies) {
  for (const int one_in : {1, 3, 50})
    for (const Vec3& sides : {Vec3(60, 3, 1), Vec3(3, 60, 1), Vec3(14, 14, 1), Vec3(3, 3, 40)}) {
      SCOPED_TRACE(testing::Message() << "one in " << one_in << ", sides " << sides.transpose());
      EXPECT_FALSE(expect_complete(crowd(sides, 200, one_in, 5)).empty());
    }
}

TEST(FastPairs, OfTwoBodiesThatAreFastOnlyTogetherAreFound) {
  Moving two;
  // Each moves by 0.03 m, less than half of the thickness of 0.1 m, and both together by more.
  for (const double side : {-1.0, 1.0}) {
    add_body(two.bodies, floe_shape(regular_outline(6, 0.5), 0.1), Vec3(0.52 * side, 0, 0));
    two.v.push_back(Vec3(-0.3 * side, 0, 0));
    two.w.push_back(Vec3::Zero());
  }
  EXPECT_EQ(expect_complete(two), (Pairs{{0, 1}}));
}

TEST(FastPairs, AreNoneWhereAllDriftAlike) {
  Moving drift = crowd(Vec3(20, 20, 1), 50, 1, 3);
  for (int b = 0; b < drift.bodies.size(); ++b) {
    drift.v[b] = Vec3(0.1, 0, 0);
    drift.w[b] = Vec3::Zero();
  }
  EXPECT_TRUE(expect_complete(drift).empty());
}

}  // namespace fast_pairs_test
