/// Mirrored bodies have mirrored contacts, to the last bit and however their corners are numbered.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "contact/detect/detector.h"
#include "contact/detect/swept.h"
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

/// One of the shapes that are their own images: a box, a ball or a cylinder.
geometry::Shape own_image(RandomStream& random, int kind) {
  const auto length = [&] { return random.uniform(0.2, 1); };
  if (kind == 0) return geometry::box_shape({length(), length(), length()});
  if (kind == 1) return geometry::sphere_shape(0.5 * length());
  return geometry::cylinder_shape(0.5 * length(), length());
}

struct ShapePair {
  const char* name;
  int a, b;  ///< kinds of own_image
};

class MirroredShapes : public testing::TestWithParam<ShapePair> {
 protected:
  /// Draws a pair that may touch, and its image.
  void draw(RandomStream& random) {
    port = {};
    starboard = {};
    const Vec3 away = random_tilt(random, 3) * Vec3(random.uniform(0.4, 1), 0, 0);
    for (const int body : {0, 1}) {
      const geometry::Shape shape = own_image(random, body == 0 ? GetParam().a : GetParam().b);
      // Some stand upright, so that faces and caps lie on each other.
      const Quat q = random.uniform(0, 1) < 0.3 ? Quat::Identity() : random_tilt(random, 3);
      const Vec3 p = Vec3(1.7, 0.3, 0.1) + body * away;
      add_body(port, shape, p, q);
      add_body(starboard, shape, mirrored(p), mirrored(q));
    }
  }

  bodies::Bodies port, starboard;
};

TEST_P(MirroredShapes, HaveMirroredPoints) {
  RandomStream random(12, GetParam().name);
  int touching = 0;
  for (int k = 0; k < 3000; ++k) {
    draw(random);
    ContactDetector one, two;
    const auto points = one.detect(port, 0.05);
    touching += points.empty() ? 0 : 1;
    ASSERT_EQ(rows(points, true), rows(two.detect(starboard, 0.05), false)) << "pair " << k;
  }
  EXPECT_GT(touching, 500);
}

TEST_P(MirroredShapes, MeetAtTheSameTime) {
  RandomStream random(13, GetParam().name);
  int hits = 0;
  for (int k = 0; k < 1000; ++k) {
    draw(random);
    std::vector<BodyMotion> motions(2), images(2);
    for (const int body : {0, 1}) {
      const Vec3 way = random_tilt(random, 3) * Vec3(0.5, 0, 0), turn = random_tilt(random, 3) * Vec3(1, 0, 0);
      motions[body] = {port.p_GB[body], port.R_GB[body], way, turn};
      images[body] = {starboard.p_GB[body], starboard.R_GB[body], mirrored(way), test::mirrored_axial(turn)};
    }
    FclShapes fcl;
    AxisSearchRoom room;
    const auto meet = [&](const bodies::Bodies& bodies, const std::vector<BodyMotion>& ways) {
      const std::vector<Part> a = make_parts(bodies, 0), b = make_parts(bodies, 1);
      return time_of_impact(a.front(), ways[0], b.front(), ways[1], fcl, room);
    };
    const TimeOfImpact one = meet(port, motions), two = meet(starboard, images);
    ASSERT_EQ(one.hit, two.hit) << "pair " << k;
    ASSERT_EQ(one.t, two.t) << "pair " << k;
    ASSERT_EQ(mirrored(one.on_a), two.on_a) << "pair " << k;
    ASSERT_EQ(mirrored(one.n), two.n) << "pair " << k;
    hits += one.hit ? 1 : 0;
  }
  EXPECT_GT(hits, 100);
}

// A cylinder's axis with a box or another cylinder is found by iteration, so that its image has other last bits.
INSTANTIATE_TEST_SUITE_P(Pairs, MirroredShapes,
                         testing::Values(ShapePair{"boxes", 0, 0}, ShapePair{"box_and_ball", 0, 1},
                                         ShapePair{"balls", 1, 1}, ShapePair{"ball_and_cylinder", 1, 2}),
                         [](const testing::TestParamInfo<ShapePair>& one) { return std::string(one.param.name); });

}  // namespace mirror_test
}  // namespace nilas::detect
