/// Areas and volumes of hulls in ice against closed forms.
#include "fracture/crush/contact_area.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/geometry/mesh.h"

namespace nilas::fracture {
namespace contact_area_test {

constexpr double k_round_off = 1e-12;  // relative; positions of order 1 m

std::vector<HullFace> faces_of(const geometry::ConvexPolytope& polytope, int part = 0) {
  std::vector<HullFace> faces;
  for (const auto& face : polytope.faces) {
    std::vector<Vec3> loop;
    for (const int v : face) loop.push_back(polytope.vertices[v]);
    faces.push_back(make_hull_face(part, std::move(loop)));
  }
  return faces;
}

geometry::ConvexPolytope moved(geometry::ConvexPolytope polytope, const Placement& by) {
  for (Vec3& x : polytope.vertices) x = by.point(x);
  geometry::complete(polytope);
  return polytope;
}

/// A wedge whose edge stands at x = 0, opening to -x with half angle `half`; flare leans its sides out upwards. Sides
/// are faces 0 and 1.
geometry::ConvexPolytope wedge(double half, double length, double bottom, double top, double flare) {
  const double lean = std::tan(flare) / std::cos(half);  // of the side's trace along y per height
  geometry::ConvexPolytope p;
  for (const double z : {bottom, top}) {
    const double tip = lean * z / std::tan(half);  // the edge leans forward with the sides
    const double wide = length * std::tan(half) + lean * z;
    p.vertices.insert(p.vertices.end(), {Vec3(tip, 0, z), Vec3(-length, wide, z), Vec3(-length, -wide, z)});
  }
  p.faces = {{1, 4, 3, 0}, {3, 5, 2, 0}, {2, 1, 0}, {4, 5, 3}, {2, 5, 4, 1}};
  geometry::complete(p);
  return p;
}

/// A sheet from x = edge on, 4 m long and 6 m wide, with its mid-plane at z = 0.
std::vector<geometry::ConvexPolytope> sheet(double edge, double thickness) {
  return {geometry::make_prism({{edge, -3}, {edge + 4, -3}, {edge + 4, 3}, {edge, 3}}, -thickness / 2, thickness / 2)};
}

TEST(ContactArea, OfAVerticalWedgeInAStraightEdge) {
  const double half = 0.4, h = 0.3;
  const auto hull = faces_of(wedge(half, 2, -1, 1, 0));
  for (const double depth : {1e-6, 0.01, 0.3, 1.2}) {
    const auto found = faces_in_ice(hull, {Mat3::Identity(), Vec3(depth, 0, 0)}, sheet(0, h));
    ASSERT_EQ(found.size(), 2u) << depth;
    for (const auto& face : found) {
      const double area = depth / std::cos(half) * h;
      EXPECT_NEAR(face.area, area, k_round_off * (h + area));
      EXPECT_NEAR(face.centroid.x(), depth / 2, k_round_off);
      EXPECT_NEAR(std::abs(face.normal.y()), std::cos(half), k_round_off);
      EXPECT_NEAR(face.normal.x(), std::sin(half), k_round_off) << "into the ice";
    }
  }
}

TEST(ContactArea, OfAFlaredWedge) {
  const double half = 0.5, h = 0.2, flare = 0.3;
  const auto hull = faces_of(wedge(half, 2, -1, 1, flare));
  // at height z the edge stands at depth + z tan(flare)/sin(half); over the whole thickness while that is positive
  const double lean = std::tan(flare) / std::sin(half), depth = 0.4;
  const auto found = faces_in_ice(hull, {Mat3::Identity(), Vec3(depth, 0, 0)}, sheet(0, h));
  ASSERT_EQ(found.size(), 2u);
  ASSERT_GT(depth - lean * h / 2, 0);
  for (const auto& face : found)
    EXPECT_NEAR(face.area, depth / std::cos(half) * h / std::cos(flare), k_round_off) << "w h / cos(flare)";
  // shallower it is a triangle, from the top down to where the edge leaves the ice
  const double shallow = 0.01, high = h / 2 + shallow / lean;
  const auto part = faces_in_ice(hull, {Mat3::Identity(), Vec3(shallow, 0, 0)}, sheet(0, h));
  ASSERT_EQ(part.size(), 2u);
  ASSERT_LT(high, h);
  for (const auto& face : part)
    EXPECT_NEAR(face.area, 0.5 * high / std::cos(flare) * lean * high / std::cos(half), k_round_off);
}

TEST(ContactArea, OfAConesFacets) {
  constexpr int k_sides = 24;
  const double h = 0.5, slope = 1.0, at_top = 0.6;  // radius of the corners grows by 1/tan(slope) per depth
  geometry::ConvexPolytope cone;
  const double top = h / 2 + 0.3, bottom = -h / 2 - 0.2;
  const auto radius = [&](double z) { return at_top + (h / 2 - z) / std::tan(slope); };
  for (const double z : {bottom, top})
    for (int k = 0; k < k_sides; ++k) {
      const double angle = 2 * k_pi * k / k_sides;
      cone.vertices.emplace_back(radius(z) * std::cos(angle), radius(z) * std::sin(angle), z);
    }
  std::vector<int> lower, upper;
  for (int k = 0; k < k_sides; ++k) {
    const int next = (k + 1) % k_sides;
    cone.faces.push_back({k, next, next + k_sides, k + k_sides});
    lower.insert(lower.begin(), k);
    upper.push_back(k + k_sides);
  }
  cone.faces.push_back(lower);
  cone.faces.push_back(upper);
  geometry::complete(cone);
  const auto found = faces_in_ice(faces_of(cone), {Mat3::Identity(), Vec3(2, 0, 0)}, sheet(0, h));
  const double inner = std::cos(k_pi / k_sides), chord = 2 * std::sin(k_pi / k_sides);
  const double slant = std::hypot(h, (radius(-h / 2) - radius(h / 2)) * inner);
  EXPECT_EQ(found.size(), static_cast<std::size_t>(k_sides));
  const double expected = k_sides * 0.5 * (radius(h / 2) + radius(-h / 2)) * chord * slant;
  EXPECT_NEAR(total_area(found), expected, k_round_off * expected);
}

TEST(ContactArea, OfFloesInPiecesIsThatOfTheWhole) {
  const auto hull = faces_of(moved(geometry::make_box(Vec3(1, 0.7, 2)),
                                   {Mat3(Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized())), Vec3(0.1, 0.2, 0.05)}));
  const geometry::ConvexPolytope whole = geometry::make_prism({{0, -3}, {4, -3}, {4, 3}, {0, 3}}, -0.1, 0.1);
  const geometry::ConvexPolytope left = geometry::make_prism({{0, -3}, {4, -3}, {4, 0.13}, {0, 0.27}}, -0.1, 0.1);
  const geometry::ConvexPolytope right = geometry::make_prism({{0, 0.27}, {4, 0.13}, {4, 3}, {0, 3}}, -0.1, 0.1);
  const double area = total_area(faces_in_ice(hull, {}, {whole}));
  ASSERT_GT(area, 0.05);
  EXPECT_NEAR(total_area(faces_in_ice(hull, {}, {left, right})), area, k_round_off * area);
}

TEST(ContactArea, DoesNotDependOnTheFrame) {
  const auto body = wedge(0.5, 2, -1, 1, 0.3);
  const auto floe = sheet(0, 0.2);
  const double area = total_area(faces_in_ice(faces_of(body), {Mat3::Identity(), Vec3(0.4, 0, 0)}, floe));
  const Placement turn{Mat3(Eigen::AngleAxisd(0.7, Vec3(1, -2, 0.5).normalized())), Vec3(3, 1, -2)};
  // both turned alike: the hull given in another frame
  const Placement back{turn.R.transpose(), Vec3(0.4, 0, 0) - turn.R.transpose() * turn.p};
  const double turned = total_area(faces_in_ice(faces_of(moved(body, turn)), back, floe));
  EXPECT_NEAR(turned, area, 10 * k_round_off * area);
}

TEST(ContactArea, OfAFaceInTheIcesSurface) {
  const auto floe = sheet(0, 0.2);
  // a box of the ice's own height: its top and bottom have no ice in front of them
  const auto level =
      faces_in_ice(faces_of(geometry::make_box(Vec3(1, 1, 0.2))), {Mat3::Identity(), Vec3(0.3, 0, 0)}, floe);
  EXPECT_NEAR(total_area(level), (1 + 0.8 + 0.8) * 0.2, k_round_off) << "front and two sides";
  // a box that stands on the ice
  const auto on_top =
      faces_in_ice(faces_of(geometry::make_box(Vec3(1, 1, 1))), {Mat3::Identity(), Vec3(1, 0, 0.6)}, floe);
  EXPECT_NEAR(total_area(on_top), 1, k_round_off);
  const auto apart =
      faces_in_ice(faces_of(geometry::make_box(Vec3(1, 1, 1))), {Mat3::Identity(), Vec3(1, 0, 0.61)}, floe);
  EXPECT_TRUE(apart.empty());
}

TEST(PressurePoints, ReproduceForceMomentAndSecondMoment) {
  const auto hull = faces_of(wedge(0.5, 2, -1, 1, 0.3));
  const auto found = faces_in_ice(hull, {Mat3::Identity(), Vec3(0.01, 0, 0)}, sheet(0, 0.2));
  ASSERT_EQ(found.size(), 2u);
  const FaceInIce& face = found.front();
  const PressurePoints all = pressure_points(face, 0);
  ASSERT_EQ(all.count, 4);
  Vec3 mean = Vec3::Zero();
  Mat3 spread = Mat3::Zero();
  for (const Vec3& x : all.points) mean += x / 4;
  for (const Vec3& x : all.points) spread += (x - mean) * (x - mean).transpose() / 4;
  EXPECT_LE((mean - face.centroid).norm(), k_round_off);
  EXPECT_LE((spread - face.spread).norm(), k_round_off * face.spread.norm());
  EXPECT_EQ(pressure_points(face, 1).count, 1);
  EXPECT_EQ(pressure_points(face, 1).points[0], face.centroid);
  const double narrow = std::sqrt(Eigen::SelfAdjointEigenSolver<Mat3>(face.spread).eigenvalues()[1]);
  const PressurePoints two = pressure_points(face, 1.01 * narrow);
  ASSERT_EQ(two.count, 2);
  EXPECT_LE((0.5 * (two.points[0] + two.points[1]) - face.centroid).norm(), k_round_off);
}

/// The reference is the formula for the second moments of a triangle.
TEST(PressurePoints, SpreadOfATriangle) {
  const auto hull = std::vector<HullFace>{make_hull_face(0, {Vec3(0, 0, 0), Vec3(0.3, 0, 0), Vec3(0, 0.6, 0)})};
  const auto found = faces_in_ice(hull, {}, {geometry::make_box(Vec3(4, 4, 4))});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].area, 0.09, k_round_off);
  EXPECT_NEAR(found[0].spread(0, 0), 0.3 * 0.3 / 18, k_round_off);
  EXPECT_NEAR(found[0].spread(1, 1), 0.6 * 0.6 / 18, k_round_off);
  EXPECT_NEAR(found[0].spread(0, 1), -0.3 * 0.6 / 36, k_round_off);
}

}  // namespace contact_area_test
}  // namespace nilas::fracture
