/// Times of impact against brute force and closed forms.
#include "contact/detect/swept.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/contact/detect/bodies_of_tests.h"
#include "tests/support/collision/swept_pairs.h"

namespace nilas::detect {
namespace swept_test {

BodyMotion motion_of(const oracle::Way& way) { return {way.p, way.q.toRotationMatrix(), way.way, way.turn}; }

/// Convex pieces of bodies that begin at the poses of a pair.
struct SweptPair {
  explicit SweptPair(const oracle::PairOnItsWay& pair) : SweptPair(mesh_of(pair.a), mesh_of(pair.b)) {
    motions = {motion_of(pair.way_a), motion_of(pair.way_b)};
  }
  SweptPair(const geometry::Shape& a, const geometry::Shape& b) : motions(2) {
    add_body(bodies, a, Vec3::Zero());
    add_body(bodies, b, Vec3::Zero());
    for (int k : {0, 1}) parts.push_back(std::move(make_parts(bodies, k).front()));
  }
  static geometry::Shape mesh_of(const geometry::ConvexPolytope& polytope) {
    geometry::Shape shape;
    shape.kind = geometry::ShapeKind::mesh;
    shape.parts = {polytope};
    shape.bounding_radius = polytope.centre.norm() + polytope.radius;
    return shape;
  }
  TimeOfImpact find() { return time_of_impact(parts[0], motions[0], parts[1], motions[1], fcl, room); }

  bodies::Bodies bodies;
  std::vector<Part> parts;
  std::vector<BodyMotion> motions;
  FclShapes fcl;
  AxisSearchRoom room;
};

class SweptPlates : public ::testing::TestWithParam<oracle::PairClass> {};

/// A hundredth of the pairs of `./dev bench collision swept`.
constexpr int k_pairs = 200;
constexpr double k_time_tolerance = 1e-6;

TEST_P(SweptPlates, CertainHitsAreFoundInTime) {
  RandomStream random(11, GetParam().name);
  int hits = 0;
  while (hits < k_pairs) {
    const oracle::PairOnItsWay pair = oracle::crossing_pair(GetParam(), random);
    if (pair.separation_at(0) <= 0) continue;
    ++hits;
    SweptPair swept(pair);
    const TimeOfImpact found = swept.find();
    ASSERT_TRUE(found.hit) << "pair " << hits;
    const oracle::FirstContact truth = oracle::first_contact(pair);
    ASSERT_TRUE(truth.hit);
    ASSERT_NEAR(found.t, truth.t, k_time_tolerance) << "pair " << hits;
    // The separation along n is the distance and no more; both points lie on the surfaces.
    const oracle::Solid a = pair.way_a.at(pair.a, found.t), b = pair.way_b.at(pair.b, found.t);
    const double resolution = 1e-8 * pair.size();
    EXPECT_NEAR(oracle::separation(a, b, found.n), 0, resolution);
    EXPECT_LE((found.on_b - found.on_a).norm(), resolution);
    for (const oracle::Solid* solid : {&a, &b}) {
      double outside = -1;
      for (std::size_t f = 0; f < solid->faces.size(); ++f)
        outside = std::max(outside, solid->normals[f].dot(found.on_a - solid->vertices[solid->faces[f].front()]));
      EXPECT_NEAR(outside, 0, resolution);
    }
  }
}

TEST_P(SweptPlates, CertainMissesAreNoHits) {
  RandomStream random(12, GetParam().name);
  int misses = 0;
  while (misses < k_pairs) {
    const oracle::PairOnItsWay pair = oracle::passing_pair(GetParam(), random);
    const oracle::FirstContact truth = oracle::first_contact(pair);
    if (!truth.certain_miss) continue;
    ++misses;
    SweptPair swept(pair);
    EXPECT_FALSE(swept.find().hit) << "pair " << misses << ", separation " << truth.least_separation;
  }
}

INSTANTIATE_TEST_SUITE_P(All, SweptPlates, ::testing::ValuesIn(oracle::pair_classes()),
                         [](const auto& instance) { return "class" + std::to_string(instance.index); });

TEST(Swept, RoundPartsAndPlanesHitAtTheirInstants) {
  const Quat aside(Eigen::AngleAxisd(0.5 * k_pi, Vec3::UnitX()));
  struct Case {
    const char* name;
    geometry::Shape a, b;
    Vec3 from, way;
    double t;
  };
  const std::vector<Case> cases{
      {"sphere on plane", geometry::plane_shape(), geometry::sphere_shape(0.1), {0, 0, 1.1}, {3, 0, -4}, 0.25},
      {"plane under sphere", geometry::sphere_shape(0.1), geometry::plane_shape(), {0, 0, -1.1}, {0, 0, 4}, 0.25},
      {"box on plane", geometry::plane_shape(), geometry::box_shape({2, 2, 0.02}), {0, 0, 1.01}, {0, 0, -4}, 0.25},
      {"cylinder on plane",
       geometry::plane_shape(),
       geometry::cylinder_shape(0.5, 0.02),
       {0, 0, 1.01},
       {0, 0, -4},
       0.25},
      {"sphere through plate",
       geometry::box_shape({2, 2, 0.02}),
       geometry::sphere_shape(0.1),
       {0, 0, 1.11},
       {0, 0, -4},
       0.25},
      {"plate through sphere",
       geometry::sphere_shape(0.1),
       geometry::box_shape({2, 2, 0.02}),
       {0, 0, 1.11},
       {0, 0, -4},
       0.25},
      {"sphere on sphere", geometry::sphere_shape(0.1), geometry::sphere_shape(0.2), {0, 0, 1.3}, {0, 0, -4}, 0.25},
      {"cylinder through plate",
       geometry::box_shape({2, 2, 0.02}),
       geometry::cylinder_shape(0.3, 0.02),
       {0, 0, 1.02},
       {0, 0, -4},
       0.25},
      {"cylinder on cylinder",
       geometry::cylinder_shape(0.5, 0.02),
       geometry::cylinder_shape(0.3, 0.02),
       {0, 0, 1.02},
       {0, 0, -4},
       0.25}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    SweptPair swept(c.a, c.b);
    swept.motions[1].p = c.from;
    swept.motions[1].way = c.way;
    const TimeOfImpact found = swept.find();
    ASSERT_TRUE(found.hit);
    EXPECT_NEAR(found.t, c.t, 1e-9);
    EXPECT_NEAR(found.n.z(), c.from.z() > 0 ? 1 : -1, 1e-9);
    EXPECT_NEAR((found.on_b - found.on_a).norm(), 0, 1e-8);
    swept.motions[1].way = -c.way;
    EXPECT_FALSE(swept.find().hit);
  }
}

/// A rod that turns in place by 2.5 rad meets a post beside it when it has turned to the post's angle.
TEST(Swept, ATurningRodMeetsThePostAtItsAngle) {
  SweptPair swept(geometry::box_shape({0.02, 0.02, 1}), geometry::box_shape({2, 0.01, 0.01}));
  const double angle = 1.2, reach = 0.8;
  swept.motions[0].p = Vec3(reach * std::cos(angle), reach * std::sin(angle), 0);
  swept.motions[0].R = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
  swept.motions[1].turn = Vec3(0, 0, 2.5);
  const TimeOfImpact found = swept.find();
  ASSERT_TRUE(found.hit);
  // the rod's long edge meets the post's corner: at local (x, y) = (0.79, -0.01) the rod's side is 0.005 from its axis
  const double radius = std::hypot(reach - 0.01, 0.01), corner = angle - std::atan2(0.01, reach - 0.01);
  EXPECT_NEAR(found.t, (corner - std::asin(0.005 / radius)) / 2.5, 1e-7);
  EXPECT_NEAR(found.n.dot(Vec3(std::sin(found.t * 2.5), -std::cos(found.t * 2.5), 0)), 1, 1e-6);
}

TEST(Swept, PartsThatTouchAtTheStartHitAtOnce) {
  SweptPair swept(geometry::box_shape({1, 1, 0.1}), geometry::box_shape({1, 1, 0.1}));
  swept.motions[1].p = Vec3(0, 0, 0.1);
  swept.motions[1].way = Vec3(0, 0, 1);
  const TimeOfImpact found = swept.find();
  EXPECT_TRUE(found.hit);
  EXPECT_EQ(found.t, 0);
}

/// Two floes side by side, a millionth of a metre apart, that turn together about the first one's centre. The second
/// one's straight path leaves the circle outward by 0.3 mm. With axes that stay in G alone it took 6418 advances.
TEST(Swept, PartsThatTurnTogetherNeedFewAdvances) {
  SweptPair swept(geometry::box_shape({10, 10, 0.5}), geometry::box_shape({8, 6, 0.5}));
  constexpr double gap = 1e-6, turn = 8e-3;
  const Vec3 between(9 + gap, 1, 0);
  swept.motions[1].p = between;
  for (BodyMotion& motion : swept.motions) motion.turn = Vec3(0, 0, turn);
  swept.motions[1].way = Vec3(0, 0, turn).cross(between);
  for (const bool second_is_host : {false, true}) {
    if (second_is_host) {
      std::swap(swept.parts[0], swept.parts[1]);
      std::swap(swept.motions[0], swept.motions[1]);
    }
    const TimeOfImpact found = swept.find();
    EXPECT_FALSE(found.hit);
    EXPECT_LE(found.advances, 5);
  }
}

/// A floe at rest, met by the face of one that turns.
TEST(Swept, AFaceThatTurnsMeetsACornerAtItsAngle) {
  SweptPair swept(geometry::box_shape({10, 10, 0.5}), geometry::box_shape({2, 2, 0.5}));
  constexpr double turn = 0.5, angle = 0.3;
  // the second floe's corner (-1, -1) lies where the first one's face x = 5 is after `angle`, 2 m from its middle
  const Vec3 corner = Eigen::AngleAxisd(angle, Vec3::UnitZ()) * Vec3(5, -2, 0);
  swept.motions[0].turn = Vec3(0, 0, turn);
  swept.motions[1].p = corner - Vec3(-1, -1, 0);
  const TimeOfImpact found = swept.find();
  ASSERT_TRUE(found.hit);
  EXPECT_NEAR(found.t, angle / turn, 1e-7);
}

TEST(Swept, FarFromTheOriginTheTimeIsTheSame) {
  RandomStream random(13, "far");
  for (int k = 0; k < 20; ++k) {
    oracle::PairOnItsWay pair = oracle::crossing_pair({"far", 100, 100, 1}, random);
    if (pair.separation_at(0) <= 0) continue;
    const TimeOfImpact near = SweptPair(pair).find();
    for (auto* way : {&pair.way_a, &pair.way_b}) way->p += Vec3(1e5, -1e5, 3);
    const TimeOfImpact far = SweptPair(pair).find();
    EXPECT_TRUE(far.hit);
    EXPECT_NEAR(far.t, near.t, k_time_tolerance);
  }
}

}  // namespace swept_test
}  // namespace nilas::detect
