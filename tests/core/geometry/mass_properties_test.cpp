#include "core/geometry/mass_properties.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/geometry/shape.h"
#include "tests/core/bodies/solids.h"
#include "tests/support/about_centroid.h"
#include "tests/support/mirrored.h"
#include "tests/support/random_vectors.h"
#include "tests/support/tetrahedron.h"

namespace nilas::geometry {
namespace mass_properties_test {

constexpr double k_exact = 1e-12;  // of the largest entry

void expect_equal(const MassProperties& a, const MassProperties& b, double share = k_exact) {
  EXPECT_NEAR(a.mass, b.mass, share * b.mass);
  const double size = std::sqrt(b.inertia.trace() / b.mass);
  EXPECT_LE((a.com - b.com).norm(), share * size);
  EXPECT_LE((a.inertia - b.inertia).norm(), share * b.inertia.norm()) << a.inertia << "\n\n" << b.inertia;
}

/// A renumbered mirror image, begun at other corners, of a lopsided tetrahedron far from the origin.
TEST(MeshProperties, HaveMirroredBitsForMirroredMeshes) {
  RandomStream random(6, "mesh");
  for (int k = 0; k < 100; ++k) {
    TriangleMesh mesh;
    for (int i = 0; i < 4; ++i)
      mesh.vertices.push_back(Vec3(3, 5, -2) + Vec3(random.normal(), random.normal(), random.normal()));
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    const Vec3 a = mesh.vertices[1] - mesh.vertices[0], b = mesh.vertices[2] - mesh.vertices[0];
    if (a.cross(b).dot(mesh.vertices[3] - mesh.vertices[0]) < 0) std::swap(mesh.vertices[1], mesh.vertices[2]);
    TriangleMesh image;
    for (const Vec3& x : mesh.vertices) image.vertices.insert(image.vertices.begin(), test::mirrored(x));
    for (const auto& t : mesh.triangles)
      image.triangles.insert(image.triangles.begin(), {3 - t[1], 3 - t[0], 3 - t[2]});
    const MassProperties one = mesh_properties(mesh, 900), two = mesh_properties(image, 900);
    EXPECT_EQ(one.mass, two.mass);
    EXPECT_EQ(one.com, test::mirrored(two.com));
    const Vec3 signs(1, -1, 1);
    EXPECT_EQ(one.inertia, Mat3(signs.asDiagonal() * two.inertia * signs.asDiagonal()));
  }
}

/// The bits do not depend on the outline's first corner, nor on a mirror, which reverses the outline.
TEST(PolygonMoments, HaveMirroredBitsForMirroredOutlines) {
  RandomStream random(4, "moments");
  for (int k = 0; k < 200; ++k) {
    std::vector<Vec2> outline;
    for (int i = 0; i < 7; ++i) {
      const double angle = 2 * k_pi * (i + random.uniform(-0.3, 0.3)) / 7, r = random.uniform(0.5, 1.5);
      outline.emplace_back(3 + r * std::cos(angle), 40 + r * std::sin(angle));
    }
    const std::vector<Vec2> image = test::mirrored(outline, static_cast<std::size_t>(k));
    const PolygonMoments one = polygon_moments(outline), two = polygon_moments(image);
    EXPECT_EQ(one.area, two.area);
    EXPECT_EQ(one.centroid, Vec2(two.centroid.x(), -two.centroid.y()));
    EXPECT_EQ(one.xx, two.xx);
    EXPECT_EQ(one.yy, two.yy);
    EXPECT_EQ(one.xy, -two.xy);
  }
}

/// A triangle's second moments about its centroid: area / 36 times sums of squares of the edges' components.
TEST(PolygonMoments, RightTriangle) {
  const double b = 3, h = 2;
  const PolygonMoments m = polygon_moments({{0, 0}, {b, 0}, {0, h}});
  EXPECT_NEAR(m.area, b * h / 2, k_exact);
  EXPECT_NEAR((m.centroid - Vec2(b / 3, h / 3)).norm(), 0, k_exact);
  EXPECT_NEAR(m.xx, h * b * b * b / 36, k_exact);
  EXPECT_NEAR(m.yy, b * h * h * h / 36, k_exact);
  EXPECT_NEAR(m.xy, -b * b * h * h / 72, k_exact);
}

/// L of two rectangles: parallel-axis sums.
TEST(PolygonMoments, ConcaveL) {
  const PolygonMoments m = polygon_moments(bodies::l_outline());
  // 3 x 1 about (1.5, 0.5) and 1 x 3 about (0.5, 2.5)
  EXPECT_NEAR(m.area, 6, k_exact);
  EXPECT_NEAR((m.centroid - Vec2(1, 1.5)).norm(), 0, k_exact);
  EXPECT_NEAR(m.xx, (27.0 + 3.0) / 12 + 3 * 0.25 + 3 * 0.25, k_exact);
  EXPECT_NEAR(m.yy, (3.0 + 27.0) / 12 + 3 * 1 + 3 * 1, k_exact);
  EXPECT_NEAR(m.xy, 3 * 0.5 * -1 + 3 * -0.5 * 1, k_exact);
}

/// Star of 2k triangles (0, outer, inner): area k R r sin(pi/k); by symmetry xx = yy, xy = 0, and the polar moment is
/// that of its triangles, area/6 (R^2 + R r cos(pi/k) + r^2) in all.
TEST(PolygonMoments, RegularStar) {
  const double R = 2, r = 0.7;
  for (const int k : {3, 5, 8}) {
    const PolygonMoments m = polygon_moments(bodies::star_outline(k, R, r));
    const double area = k * R * r * std::sin(k_pi / k);
    const double polar = area / 6 * (R * R + R * r * std::cos(k_pi / k) + r * r);
    EXPECT_NEAR(m.area, area, k_exact * area);
    EXPECT_NEAR(m.centroid.norm(), 0, k_exact);
    EXPECT_NEAR(m.xx + m.yy, polar, k_exact * polar);
    EXPECT_NEAR(m.xx, m.yy, k_exact * polar);
    EXPECT_NEAR(m.xy, 0, k_exact * polar);
  }
}

TEST(PolygonMoments, ClockwiseTurnsEverySign) {
  auto outline = bodies::l_outline();
  std::reverse(outline.begin(), outline.end());
  const PolygonMoments m = polygon_moments(outline), straight = polygon_moments(bodies::l_outline());
  EXPECT_EQ(m.area, -straight.area);
  EXPECT_NEAR((m.centroid - straight.centroid).norm(), 0, k_exact);
  EXPECT_NEAR(m.xx, -straight.xx, k_exact);
}

/// A floe far along a long tank: binary steps of the offset keep the outline exact, so the moments must stay.
TEST(PolygonMoments, FarOffOutlinesLoseNoDigits) {
  const PolygonMoments near = polygon_moments(bodies::l_outline());
  auto outline = bodies::l_outline();
  for (auto& p : outline) p += Vec2(65536, -32768);
  const PolygonMoments far = polygon_moments(outline);
  EXPECT_NEAR(far.area, near.area, k_exact * near.area);
  EXPECT_NEAR(far.xx, near.xx, 1e-9 * near.xx);  // the centroid itself is only good to 1e-11 m there
  EXPECT_NEAR(far.xy, near.xy, 1e-9 * std::abs(near.xy));
}

TEST(MassProperties, PrismOfARectangleIsABox) {
  const Vec3 size(3, 2, 0.4);
  const std::vector<Vec2> outline{{-1.5, -1}, {1.5, -1}, {1.5, 1}, {-1.5, 1}};
  expect_equal(prism_properties(outline, size.z(), 900), box_properties(size, 900 * size.prod()));
}

TEST(MassProperties, MeshesOfPrismsAgreeWithTheClosedForm) {
  RandomStream random(7, "outlines");
  std::vector<std::vector<Vec2>> outlines{bodies::l_outline(), bodies::star_outline(5, 2, 0.7)};
  for (int i = 0; i < 50; ++i) outlines.push_back(bodies::random_star_polygon(random));
  for (const auto& raw : outlines) {
    const auto outline = test::about_centroid(raw);
    const double thickness = 0.3;
    expect_equal(mesh_properties(prism_shape(outline, thickness).surface, 917),
                 prism_properties(outline, thickness, 917));
  }
}

TEST(MassProperties, PrismKeepsTheOffsetOfItsOutline) {
  const MassProperties p = prism_properties(bodies::l_outline(), 0.5, 800);
  EXPECT_NEAR(p.mass, 2400, k_exact * 2400);
  EXPECT_NEAR((p.com - Vec3(1, 1.5, 0)).norm(), 0, k_exact);
  EXPECT_NEAR(p.inertia(0, 1), -400 * polygon_moments(bodies::l_outline()).xy, 1e-9);
}

/// Corner tetrahedron with legs a, b, c: m = rho a b c / 6, com at a quarter, and about the com
/// I_xx = 3 m (b^2 + c^2) / 80, I_xy = + m a b / 80 (tensor entry: -integral of x y, which is -m a b / 80).
TEST(MassProperties, CornerTetrahedron) {
  const double a = 1.5, b = 2, c = 0.8, rho = 1000, m = rho * a * b * c / 6;
  MassProperties expected;
  expected.mass = m;
  expected.com = {a / 4, b / 4, c / 4};
  expected.inertia << 3 * (b * b + c * c), a * b, a * c,  //
      a * b, 3 * (a * a + c * c), b * c,                  //
      a * c, b * c, 3 * (a * a + b * b);
  expected.inertia *= m / 80;
  expect_equal(mesh_properties(test::tetrahedron({0, 0, 0}, {a, 0, 0}, {0, b, 0}, {0, 0, c}), rho), expected);
}

/// A solid with the symmetry of the cube is isotropic: octahedron with vertices at distance r, m = 4/3 rho r^3 and
/// I = m r^2 / 5.
TEST(MassProperties, Octahedron) {
  const double r = 1.3, m = 500 * 4.0 / 3 * r * r * r;
  MassProperties expected;
  expected.mass = m;
  expected.inertia = m * r * r / 5 * Mat3::Identity();
  expect_equal(mesh_properties(bodies::moved(bodies::octahedron(), r * Mat3::Identity(), Vec3::Zero()), 500), expected);
}

/// The facets' error falls with the square of their size; extrapolated it vanishes to fourth order.
TEST(MassProperties, SphereMeshesTendToTheSphere) {
  const double r = 0.9, volume = 4.0 / 3 * k_pi * r * r * r;
  const MassProperties exact = sphere_properties(r, volume);
  double before = 0;
  for (const int levels : {3, 4, 5}) {
    const MassProperties p = mesh_properties(bodies::sphere_mesh(r, levels), 1);
    const double error = 1 - p.mass / exact.mass;
    EXPECT_LT(p.com.norm(), k_exact);
    EXPECT_NEAR(p.inertia(0, 0), p.inertia(2, 2), k_exact);
    EXPECT_GT(error, 0);
    if (before > 0) {
      EXPECT_NEAR(before / error, 4, 0.1);
    }
    before = error;
  }
  EXPECT_NEAR(mesh_properties(bodies::sphere_mesh(r, 5), 1).inertia(0, 0) / exact.inertia(0, 0), 1, 3e-3);
}

/// Regular n-gon prisms: exact polar moment m R^2 (2 + cos(2 pi/n)) / 6, tending to the cylinder's m R^2 / 2.
TEST(MassProperties, ManySidedPrismsTendToTheCylinder) {
  const double R = 0.6, h = 0.5;
  double before = 0;
  for (const int n : {64, 128, 256}) {
    std::vector<Vec2> outline;
    for (int i = 0; i < n; ++i) outline.emplace_back(R * std::cos(2 * k_pi * i / n), R * std::sin(2 * k_pi * i / n));
    const MassProperties p = prism_properties(outline, h, 1);
    const double across = p.mass * (R * R * (2 + std::cos(2 * k_pi / n)) / 12 + h * h / 12);
    EXPECT_NEAR(p.inertia(2, 2), p.mass * R * R * (2 + std::cos(2 * k_pi / n)) / 6, k_exact);
    EXPECT_NEAR(p.inertia(0, 0), across, k_exact);
    const MassProperties round = cylinder_properties(R, h, k_pi * R * R * h);
    const double error = 1 - p.inertia(2, 2) / round.inertia(2, 2);
    EXPECT_GT(error, 0);
    if (before > 0) {
      EXPECT_NEAR(before / error, 4, 0.02);
    }
    before = error;
  }
}

TEST(MassProperties, CylinderIsTheLimitOfFlatAndSlender) {
  const MassProperties disc = cylinder_properties(2, 1e-9, 3), rod = cylinder_properties(1e-9, 2, 3);
  EXPECT_NEAR(disc.inertia(2, 2), 6, k_exact);
  EXPECT_NEAR(disc.inertia(0, 0), 3, k_exact);
  EXPECT_NEAR(rod.inertia(0, 0), 1, k_exact);
}

/// Turned and moved mesh: I' = R I R^T, com' = R com + p, whatever the place of the origin.
TEST(MassProperties, MovedMeshesKeepTheirInertia) {
  RandomStream random(3, "attitudes");
  const TriangleMesh mesh = prism_shape(test::about_centroid(bodies::l_outline()), 0.7).surface;
  const MassProperties here = mesh_properties(mesh, 900);
  for (int i = 0; i < 20; ++i) {
    const Mat3 R = test::random_attitude(random).toRotationMatrix();
    const Vec3 p(random.uniform(-10, 10), random.uniform(-10, 10), random.uniform(-10, 10));
    MassProperties expected = here;
    expected.com = R * here.com + p;
    expected.inertia = R * here.inertia * R.transpose();
    expect_equal(mesh_properties(bodies::moved(mesh, R, p), 900), expected);
    EXPECT_TRUE(physically_valid_inertia(expected.inertia));
  }
}

TEST(MassProperties, WrongSolidsBreakTheContract) {
  TriangleMesh inward = bodies::octahedron();
  for (auto& t : inward.triangles) std::swap(t[0], t[1]);
  EXPECT_THROW(mesh_properties(inward, 1), ContractError);
  EXPECT_THROW(mesh_properties({}, 1), ContractError);
  EXPECT_THROW(prism_properties({{0, 0}, {0, 1}, {1, 0}}, 1, 1), ContractError);
  EXPECT_THROW(prism_properties(bodies::l_outline(), 0, 1), ContractError);
  EXPECT_THROW(box_properties({1, -1, 1}, 1), ContractError);
  EXPECT_THROW(sphere_properties(1, std::nan("")), ContractError);
}

TEST(PhysicallyValidInertia, TriangleInequalityAndSigns) {
  const auto valid = [](double a, double b, double c) {
    const Mat3 R = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    return physically_valid_inertia(R * Vec3(a, b, c).asDiagonal() * R.transpose());
  };
  EXPECT_TRUE(valid(1, 1, 1));
  EXPECT_TRUE(valid(1, 2, 3));  // a flat plate sits on the limit
  EXPECT_FALSE(valid(1, 2, 3.0001));
  EXPECT_FALSE(valid(3.0001, 1, 2));
  EXPECT_FALSE(valid(0, 1, 1));
  EXPECT_FALSE(valid(-1, -1, -1));
  Mat3 skewed = Mat3::Identity();
  skewed(0, 1) = 0.1;
  EXPECT_FALSE(physically_valid_inertia(skewed));
  EXPECT_FALSE(physically_valid_inertia(Mat3::Constant(std::nan(""))));
}

}  // namespace mass_properties_test
}  // namespace nilas::geometry
