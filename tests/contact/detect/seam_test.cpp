/// Tests of bodies of several convex pieces that touch or overlap: faces between the pieces are not part of the
/// surface.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/detect/broad/part.h"
#include "contact/detect/detector.h"
#include "tests/contact/detect/bodies_of_tests.h"
#include "tests/support/about_centroid.h"
#include "tests/support/random_vectors.h"

namespace nilas::detect {
namespace seam_test {

constexpr double k_depth = 1e-3;

geometry::ConvexPolytope box_part(const Vec3& low, const Vec3& high) {
  geometry::ConvexPolytope box = geometry::make_box(high - low);
  for (Vec3& v : box.vertices) v += 0.5 * (low + high);
  geometry::complete(box);
  return box;
}

/// A wall along x from -4 to 4, y from -1 to 0, z from -0.5 to 0.5, cut into the given stretches of x.
geometry::Shape wall(const std::vector<std::pair<double, double>>& stretches) {
  std::vector<geometry::ConvexPolytope> parts;
  for (const auto& [from, to] : stretches) parts.push_back(box_part({from, -1, -0.5}, {to, 0, 0.5}));
  return geometry::mesh_shape(geometry::box_shape({8, 1, 1}).surface, parts);
}

const std::vector<std::vector<std::pair<double, double>>> k_walls{{{-4, 4}},
                                                                  {{-4, 0}, {0, 4}},
                                                                  {{-4, 0.7}, {0.1, 4}},
                                                                  {{-4, -1}, {-1, 0.3}, {0.2, 0.4}, {0.4, 4}},
                                                                  {{-4, 4}, {-1, 1}}};

TEST(Seams, InnerFacesAndEdgesAreKnown) {
  bodies::Bodies bodies;
  add_body(bodies, wall({{-4, 0}, {0, 4}}), {0, 0, 0});
  for (const Part& part : make_parts(bodies, 0)) {
    ASSERT_TRUE(part.cover);
    const auto& polytope = *part.facets->polytope;
    for (std::size_t f = 0; f < polytope.normals.size(); ++f)
      EXPECT_EQ(part.cover->face_is_internal[f] != 0,
                std::abs(polytope.offsets[f]) < 1e-12 && std::abs(polytope.normals[f].x()) > 0.5)
          << f;
    for (std::size_t e = 0; e < part.facets->edges.size(); ++e)
      EXPECT_EQ(part.cover->edge_is_internal[e] != 0, std::abs(part.facets->middle(part.facets->edges[e]).x()) < 1e-12)
          << e;
  }
  bodies::Bodies partly;
  add_body(partly,
           geometry::mesh_shape(geometry::box_shape({8, 1, 1}).surface,
                                {box_part({-4, -1, -0.5}, {0, 0, 0.5}), box_part({0, -1, -0.5}, {4, 0, 0.7})}),
           {0, 0, 0});
  const auto parts = make_parts(partly, 0);
  const auto inner = [](const Part& part) {
    return std::count(part.cover->face_is_internal.begin(), part.cover->face_is_internal.end(), 1);
  };
  EXPECT_EQ(inner(parts[0]), 1);
  EXPECT_EQ(inner(parts[1]), 0);
}

TEST(Seams, OnePartAloneHasNoCover) {
  bodies::Bodies bodies;
  add_body(bodies, wall({{-4, 4}}), {0, 0, 0});
  EXPECT_FALSE(make_parts(bodies, 0)[0].cover);
}

/// Moves the floe along the wall in steps that pass the seams, at depths between touching and deep.
void expect_contacts_of_one_wall(const std::vector<std::pair<double, double>>& stretches, const geometry::Shape& floe,
                                 const Vec3& at, const Vec3& out, const Quat& turn) {
  bodies::Bodies one, several;
  for (auto& [bodies, shape] :
       {std::pair<bodies::Bodies&, geometry::Shape>{one, wall({{-4, 4}})}, {several, wall(stretches)}}) {
    add_body(bodies, shape, {0, 0, 0}, Quat::Identity(), bodies::Motion::fixed);
    add_body(bodies, floe, at, turn);
  }
  ContactDetector of_one, of_several;
  for (double depth : {-1e-4, 1e-12, 1e-6, 1e-3, 0.05})
    for (int k = 0; k <= 400; ++k) {
      const Vec3 p = at - depth * out + Vec3(-1.5 + 0.0075 * k, 0, 0);
      one.set_pose(1, p, turn);
      several.set_pose(1, p, turn);
      const auto whole = of_one.detect(one, 0.01), parted = of_several.detect(several, 0.01);
      ASSERT_EQ(whole.size(), parted.size()) << depth << " " << k;
      for (const ContactPoint& c : whole) {
        double nearest = 1;
        for (const ContactPoint& d : parted)
          nearest = std::min(nearest, (c.p - d.p).norm() + (c.n - d.n).norm() + std::abs(c.gap - d.gap));
        EXPECT_LT(nearest, 1e-12) << depth << " " << k;
      }
    }
}

TEST(Seams, AFloeBesideTouchesAsOnOneSide) {
  for (const auto& stretches : k_walls)
    expect_contacts_of_one_wall(stretches, geometry::box_shape({1, 1, 0.2}), {0, 0.5, 0.1}, Vec3::UnitY(),
                                Quat::Identity());
}

TEST(Seams, AFloeOnTopAndBelowTouchesAsOnOneFace) {
  for (const auto& stretches : k_walls)
    for (double side : {1.0, -1.0})
      expect_contacts_of_one_wall(stretches, geometry::box_shape({1, 0.5, 0.2}), {0, -0.4, 0.6 * side},
                                  side * Vec3::UnitZ(), Quat::Identity());
}

TEST(Seams, AFloeThatIsAskewTouchesWithItsCorner) {
  const Quat turn(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));
  const double reach = 0.5 * (std::cos(0.3) + std::sin(0.3));
  for (const auto& stretches : k_walls)
    expect_contacts_of_one_wall(stretches, geometry::box_shape({1, 1, 0.2}), {0, reach, 0.1}, Vec3::UnitY(), turn);
}

TEST(Seams, ASlightlyTurnedFloeTouchesAsOnOneSide) {
  for (const auto& stretches : k_walls)
    for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(1, 0.5, 2), Vec3(-0.4, 0.3, -1)}) {
      const Quat turn(Eigen::AngleAxisd(2e-3, axis.normalized()));
      expect_contacts_of_one_wall(stretches, geometry::box_shape({1, 1, 0.2}), {0, 0.501, 0.1}, Vec3::UnitY(), turn);
    }
}

TEST(Seams, DiscsAndBallsPassSeams) {
  for (const auto& stretches : k_walls) {
    expect_contacts_of_one_wall(stretches, geometry::cylinder_shape(0.5, 0.2), {0, 0.5, 0.1}, Vec3::UnitY(),
                                Quat::Identity());
    expect_contacts_of_one_wall(stretches, geometry::sphere_shape(0.5), {0, 0.5, 0.1}, Vec3::UnitY(), Quat::Identity());
  }
}

/// The ring around a convex outline, counter-clockwise about the origin: one part per edge, out to twice the distance.
geometry::Shape ring_around(const std::vector<Vec2>& outline, double thickness) {
  std::vector<geometry::ConvexPolytope> parts;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec2 &p = outline[k], &q = outline[(k + 1) % outline.size()];
    parts.push_back(geometry::make_prism({2 * p, 2 * q, q, p}, -0.5 * thickness, 0.5 * thickness));
  }
  return geometry::mesh_shape(geometry::box_shape({8, 8, thickness}).surface, parts);
}

/// A piece that fills a notch of its sheet: each side of it lies between two inner corners of the sheet, where the
/// parts at both corners hide the ends of the side. The sheet holds the piece along all its sides all the same.
TEST(Seams, APieceThatFillsANotchTouchesAllItsSides) {
  RandomStream random(3, "notch");
  for (int round = 0; round < 20; ++round) {
    const std::vector<Vec2> outline = test::about_centroid(random_outline(random, 1.5));
    for (const double gap : {1e-4, 1e-9, 0.0, -1e-9, -1e-6}) {
      const Quat turn = random_tilt(random, 0.2);
      bodies::Bodies bodies;
      add_body(bodies, ring_around(outline, 0.4), {3, 4, 0}, turn);
      std::vector<Vec2> piece = outline;  // smaller by about the gap on all sides
      for (Vec2& corner : piece) corner *= 1 - gap;
      add_body(bodies, geometry::prism_shape(piece, 0.4), {3, 4, 0}, turn);
      const auto points = ContactDetector().detect(bodies, 0.01);
      for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2 along = (outline[(k + 1) % outline.size()] - outline[k]).normalized();
        const Vec3 n = turn * Vec3(-along.y(), along.x(), 0);
        double least = 1e9, most = -1e9;
        for (const ContactPoint& c : points) {
          if (c.part_a != static_cast<int>(k) || (c.n - n).norm() > 1e-6) continue;
          const double at = (turn.conjugate() * (c.p - Vec3(3, 4, 0))).head<2>().dot(along);
          least = std::min(least, at);
          most = std::max(most, at);
          EXPECT_NEAR(c.gap, gap, std::abs(gap) + 1e-12);
        }
        const double length = (outline[(k + 1) % outline.size()] - outline[k]).norm();
        EXPECT_NEAR(most - least, length, 1e-3) << round << " " << gap << " side " << k;
      }
    }
  }
}

/// Arms along x and y, [0, 2] x [0, 1] and [0, 1] x [0, 2], in several decompositions.
TEST(Seams, AConcaveCornerKeepsBothContacts) {
  const auto arm = [](double x0, double y0, double x1, double y1) { return box_part({x0, y0, -0.5}, {x1, y1, 0.5}); };
  const std::vector<std::vector<geometry::ConvexPolytope>> partings{
      {arm(0, 0, 2, 1), arm(0, 0, 1, 2)},
      {arm(0, 0, 2, 1), arm(0, 1, 1, 2)},
      {arm(1, 0, 2, 1), arm(0, 0, 1, 2)},
      {arm(0, 0, 1, 1), arm(1, 0, 2, 1), arm(0, 1, 1, 2)}};
  for (const auto& parts : partings)
    for (double depth : {1e-9, 1e-4, 5e-3}) {
      bodies::Bodies bodies;
      add_body(bodies, geometry::mesh_shape(geometry::box_shape({4, 4, 1}).surface, parts), {0, 0, 0}, Quat::Identity(),
               bodies::Motion::fixed);
      add_body(bodies, geometry::box_shape({0.6, 0.6, 0.2}), {1.3 - depth, 1.3 - 2 * depth, 0});
      int along_x = 0, along_y = 0;
      double nearest_to_corner = 1;
      const auto points = ContactDetector().detect(bodies, 0.01);
      for (const ContactPoint& c : points) {
        const bool is_x = (c.n - Vec3::UnitX()).norm() < 1e-12;
        ASSERT_TRUE(is_x || (c.n - Vec3::UnitY()).norm() < 1e-12) << c.n.transpose();
        EXPECT_NEAR(c.gap, is_x ? -depth : -2 * depth, 1e-12);
        (is_x ? along_x : along_y) += 1;
        nearest_to_corner = std::min(nearest_to_corner, (is_x ? c.p.y() : c.p.x()) - 1);
      }
      EXPECT_EQ(along_x, 4);
      EXPECT_EQ(along_y, 4);
      EXPECT_NEAR(nearest_to_corner, 0, 1e-5);  // The floe is held up to the corner itself.
    }
}

/// A face half hidden by the neighbour touches with its visible half.
TEST(Seams, AFaceThatStandsOutTouchesWithWhatStandsOut) {
  bodies::Bodies bodies;
  const std::vector<geometry::ConvexPolytope> parts{box_part({-4, -1, -0.5}, {0, 0, 0.5}),
                                                    box_part({0, -1, -0.5}, {4, 0, 1.5})};
  add_body(bodies, geometry::mesh_shape(geometry::box_shape({8, 1, 3}).surface, parts), {0, 0, 0}, Quat::Identity(),
           bodies::Motion::fixed);
  add_body(bodies, geometry::box_shape({0.6, 0.6, 0.6}), {-0.3 + 1e-3, -0.5, 0.8 - 1e-4});
  int against_the_step = 0, on_top = 0;
  for (const ContactPoint& c : ContactDetector().detect(bodies, 0.01)) {
    const bool is_step = (c.n + Vec3::UnitX()).norm() < 1e-12;
    ASSERT_TRUE(is_step || (c.n - Vec3::UnitZ()).norm() < 1e-12) << c.n.transpose();
    EXPECT_NEAR(c.gap, is_step ? -1e-3 : -1e-4, 1e-12);
    EXPECT_TRUE(!is_step || c.p.z() > 0.5);
    (is_step ? against_the_step : on_top) += 1;
  }
  EXPECT_EQ(against_the_step, 4);
  EXPECT_EQ(on_top, 4);
}

/// A convex floe cut in pieces, side by side or overlapping, has the depth and the normal of the whole floe.
TEST(Seams, APartedFloeTouchesAsTheWholeOne) {
  RandomStream random(17, "parted");
  int compared = 0;
  for (int k = 0; k < 600; ++k) {
    const geometry::Shape whole = floe_shape(random_outline(random, 1), 0.3);
    const double at = random.uniform(-0.4, 0.4), overlap = k % 2 == 0 ? 0.0 : random.uniform(0, 0.3);
    const auto side = [&](double sign) {
      std::vector<Vec2> kept;
      const auto& outline = whole.outline;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 &p = outline[i], &q = outline[(i + 1) % outline.size()];
        const double at_p = sign * (p.x() - at) + overlap, at_q = sign * (q.x() - at) + overlap;
        if (at_p >= 0) kept.push_back(p);
        if ((at_p >= 0) != (at_q >= 0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
      }
      return geometry::make_prism(kept, -0.15, 0.15);
    };
    const geometry::Shape parted = geometry::mesh_shape(whole.surface, {side(1), side(-1)});
    const geometry::Shape other = floe_shape(random_outline(random, 0.6), 0.3);
    const Vec3 way = Vec3(random.normal(), random.normal(), k % 3 == 0 ? 2.0 : 0.05 * random.normal()).normalized();
    const Quat turn = random_tilt(random, 0.02), other_turn = random_tilt(random, 0.02);
    const auto placed = [&](const geometry::Shape& shape, double distance) {
      bodies::Bodies bodies;
      add_body(bodies, shape, {0, 0, 0}, turn);
      add_body(bodies, other, distance * way, other_turn);
      return bodies;
    };
    const auto deepest = [](const std::vector<ContactPoint>& points) {
      return *std::min_element(points.begin(), points.end(),
                               [](const auto& p, const auto& q) { return p.gap < q.gap; });
    };
    double near = 0, far = 4;  // Touching lies between these distances.
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (near + far);
      const auto points = ContactDetector().detect(placed(whole, middle), 0.01);
      (!points.empty() && deepest(points).gap < 0 ? near : far) = middle;
    }
    for (double sink : {-2e-4, 1e-5, 1e-3}) {
      const auto of_whole = ContactDetector().detect(placed(whole, near - sink), 0.002);
      const auto of_parted = ContactDetector().detect(placed(parted, near - sink), 0.002);
      ASSERT_EQ(of_whole.empty(), of_parted.empty()) << k;
      if (of_whole.empty()) continue;
      const ContactPoint one = deepest(of_whole), several = deepest(of_parted);
      EXPECT_NEAR(one.gap, several.gap, 1e-10) << k << " " << sink;
      EXPECT_LT((one.n - several.n).norm(), 1e-6) << k << " " << sink;
      for (const ContactPoint& c : of_parted)  // The tolerance is that of the two tilts.
        EXPECT_TRUE(c.gap > 0 || (c.n - one.n).norm() < 0.04) << k << " " << sink;
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000);
}

/// A body is found at any depth. Up to half the thinner body's thickness the depth is right, too.
TEST(Seams, ABodyDeepInAPartedOneIsFound) {
  const geometry::Shape whole = geometry::box_shape({2, 1, 0.5});
  const std::vector<geometry::Shape> parted{
      geometry::mesh_shape(whole.surface,
                           {box_part({-1, -0.5, -0.25}, {0, 0.5, 0.25}), box_part({0, -0.5, -0.25}, {1, 0.5, 0.25})}),
      geometry::mesh_shape(whole.surface,
                           {box_part({-1, -0.5, -0.25}, {0, 0, 0.25}), box_part({0, -0.5, -0.25}, {1, 0, 0.25}),
                            box_part({-1, 0, -0.25}, {0, 0.5, 0.25}), box_part({0, 0, -0.25}, {1, 0.5, 0.25})})};
  RandomStream random(3, "deep");
  int deep = 0;
  for (int k = 0; k < 4000; ++k) {
    const Vec3 p(random.uniform(-0.3, 0.3), random.uniform(-0.55, 0.55), random.uniform(-0.3, 0.3));
    const Quat q = k % 2 != 0 ? random_tilt(random, 0.1) : test::random_attitude(random);
    const auto depth_in = [&](const geometry::Shape& host) {
      bodies::Bodies bodies;
      add_body(bodies, host, Vec3::Zero());
      add_body(bodies, geometry::box_shape({0.4, 0.3, 0.1}), p, q);
      double deepest = 0;
      for (const ContactPoint& c : ContactDetector().detect(bodies, 0.01)) deepest = std::max(deepest, -c.gap);
      return deepest;
    };
    const double of_whole = depth_in(whole);
    for (const geometry::Shape& host : parted) {
      const double of_parted = depth_in(host);
      EXPECT_EQ(of_parted > 0, of_whole > 0) << k << ": " << of_whole;
      EXPECT_TRUE(of_whole > 0.05 || of_parted > 0.99 * of_whole) << k << ": " << of_whole << " " << of_parted;
    }
    deep += of_whole > 0.1 ? 1 : 0;
  }
  EXPECT_GT(deep, 2000);
}

}  // namespace seam_test
}  // namespace nilas::detect
