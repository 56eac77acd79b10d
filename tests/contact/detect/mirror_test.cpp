/// Mirrored bodies have mirrored contacts, to the last bit and however their corners are numbered.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "contact/detect/detector.h"
#include "tests/contact/detect/bodies_of_tests.h"
#include "tests/support/mirrored.h"

namespace nilas::detect {
namespace mirror_test {

using test::mirrored;

using Row = std::tuple<double, double, double, double, double, double, double>;  ///< p, n, gap

/// The contacts as a set, since the order of a pair's points follows their keys.
std::vector<Row> rows(const std::vector<ContactPoint>& points, bool mirror) {
  std::vector<Row> rows;
  for (const ContactPoint& c : points) {
    const Vec3 p = mirror ? mirrored(c.p) : c.p, n = mirror ? mirrored(c.n) : c.n;
    rows.emplace_back(p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), c.gap);
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

struct MirrorCase {
  const char* name;
  double tilt;               ///< Tilt of the floes [rad].
  double nearest, farthest;  ///< Distance of the centres in radii.
  /// Rectangles are their own images, so that an edge's image may have the reverse direction.
  bool rectangles = false;
};

std::vector<Vec2> rectangle(RandomStream& random) {
  const double x = random.uniform(0.4, 1), y = random.uniform(0.4, 1);
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

class MirroredPair : public testing::TestWithParam<MirrorCase> {};

TEST_P(MirroredPair, HasMirroredPoints) {
  RandomStream random(11, GetParam().name);
  int touching = 0;
  for (int k = 0; k < 5000; ++k) {
    bodies::Bodies port, starboard;
    const double thickness = random.uniform(0.02, 0.6), turn = random.uniform(0, 2 * k_pi);
    const double distance = random.uniform(GetParam().nearest, GetParam().farthest);
    Vec3 p(1.7, 0.3, 0.1);
    for (int body = 0; body < 2; ++body) {
      const auto outline = GetParam().rectangles ? rectangle(random) : random_outline(random, 1);
      const Quat q = random_tilt(random, GetParam().tilt);
      add_body(port, floe_shape(outline, thickness), p, q);
      add_body(starboard, floe_shape(mirrored(outline, static_cast<std::size_t>(k)), thickness), mirrored(p),
               mirrored(q));
      p += Vec3(distance * std::cos(turn), distance * std::sin(turn), random.uniform(-0.2, 0.2) * thickness);
    }
    ContactDetector one, two;
    const auto points = one.detect(port, 0.05);
    touching += points.empty() ? 0 : 1;
    EXPECT_EQ(rows(points, true), rows(two.detect(starboard, 0.05), false)) << "pair " << k;
    // The second search uses the detectors' memory.
    EXPECT_EQ(rows(one.detect(port, 0.05), true), rows(two.detect(starboard, 0.05), false)) << "pair " << k;
    EXPECT_EQ(one.counts().fcl_queries, two.counts().fcl_queries) << "pair " << k;
  }
  EXPECT_GT(touching, 1000);
}

INSTANTIATE_TEST_SUITE_P(Floes, MirroredPair,
                         testing::Values(MirrorCase{"flat", 0, 1.4, 2.1}, MirrorCase{"afloat", 0.01, 1.4, 2.1},
                                         MirrorCase{"tilted", 0.6, 1.2, 2.1}, MirrorCase{"deep", 0.3, 0.6, 1.4},
                                         MirrorCase{"flat_rectangles", 0, 1.2, 2.1, true},
                                         MirrorCase{"rectangles", 0.01, 1.2, 2.1, true},
                                         MirrorCase{"tilted_rectangles", 0.6, 1, 2.1, true}),
                         [](const testing::TestParamInfo<MirrorCase>& one) { return std::string(one.param.name); });

/// Two floes that touch across the plane and are images of each other. Their points lie on the plane and their normals
/// are normal to it, so that neither floe is favoured. Otherwise a face of one is as good an axis as its image, a face
/// of the other.
TEST(MirroredPair, ImagesOfEachOtherTouchOnThePlaneBetweenThem) {
  RandomStream random(3, "across");
  int touching = 0;
  for (int k = 0; k < 5000; ++k) {
    const double thickness = random.uniform(0.02, 0.6);
    const auto outline = random_outline(random, 1);
    const Quat q = random_tilt(random, k % 2 == 0 ? 0.01 : 0.2);
    bodies::Bodies bodies;
    const geometry::Shape one = floe_shape(outline, thickness);
    double lowest = 0;
    for (const Vec3& x : one.parts.at(0).vertices) lowest = std::min(lowest, (q * x).y());
    const Vec3 p(1.7, random.uniform(-0.004, 0.02) - lowest, 0.1);
    const bool near_first = k % 3 == 0;
    const auto add = [&](bool near) {
      if (near)
        add_body(bodies, floe_shape(outline, thickness), p, q);
      else
        add_body(bodies, floe_shape(mirrored(outline, static_cast<std::size_t>(k)), thickness), mirrored(p),
                 mirrored(q));
    };
    add(near_first);
    add(!near_first);
    ContactDetector detector;
    for (int call = 0; call < 2; ++call)
      for (const ContactPoint& c : detector.detect(bodies, 0.05)) {
        ++touching;
        EXPECT_EQ(c.p.y(), 0) << "pair " << k;
        EXPECT_EQ(c.n, Vec3(0, near_first ? -1 : 1, 0)) << "pair " << k;
        const double closest = 2 * (p.y() + lowest);
        EXPECT_GE(c.gap, closest - 1e-9) << "pair " << k;
      }
  }
  EXPECT_GT(touching, 5000);
}

}  // namespace mirror_test
}  // namespace nilas::detect
