#include <gtest/gtest.h>

#include "hydro/equilibrium.h"
#include "hydro/wetted.h"
#include "tests/hydro/solids.h"
#include "tests/support/random_vectors.h"

namespace nilas::water_test {

namespace waterplane_test {

/// A prism cut level shows its outline, turned by the yaw: moments of a turned polygon by the shoelace formulas.
TEST(Waterplane, LevelPrismShowsItsOutline) {
  const auto outline = concave_outline();
  const geometry::TriangleMesh mesh = geometry::prism_shape(outline, 0.6).surface;
  const double yaw = 0.8;
  std::vector<Vec2> turned;
  for (const auto& q : outline) turned.push_back(Eigen::Rotation2Dd(yaw) * q);
  const geometry::PolygonMoments expected = geometry::polygon_moments(turned);
  const hydro::Waterplane cut =
      hydro::waterplane(mesh, Mat3(Eigen::AngleAxisd(yaw, Vec3::UnitZ())), {900, -700, 2.1}, 2);
  EXPECT_NEAR(cut.area, expected.area, 1e-12);
  EXPECT_LT((cut.centroid - Vec2(900, -700) - expected.centroid).norm(), 1e-12);
  EXPECT_NEAR(cut.xx, expected.xx, 1e-11);
  EXPECT_NEAR(cut.yy, expected.yy, 1e-11);
  EXPECT_NEAR(cut.xy, expected.xy, 1e-11);
}

/// A box L B rolled by phi: the cut is L by B / cos phi.
TEST(Waterplane, RolledBox) {
  const double L = 5, B = 2, phi = 0.2;
  const hydro::Waterplane cut = hydro::waterplane(geometry::box_shape({L, B, 1}).surface,
                                                  Mat3(Eigen::AngleAxisd(phi, Vec3::UnitX())), Vec3::Zero(), 0);
  const double b = B / std::cos(phi);
  EXPECT_NEAR(cut.area, L * b, 1e-13);
  EXPECT_NEAR(cut.xx, L * L * L * b / 12, 1e-12);
  EXPECT_NEAR(cut.yy, L * b * b * b / 12, 1e-12);
  EXPECT_NEAR(cut.xy, 0, 1e-13);
}

/// Vertices in the plane: the octahedron |x|+|y|+|z| <= 1 shows the square of its four middle vertices, area 2 and
/// integral of x^2 = 1/3 (a square of side sqrt 2, turned or not: side^4 / 12).
TEST(Waterplane, VerticesInThePlane) {
  geometry::TriangleMesh mesh;
  mesh.vertices = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int k = 0; k < 4; ++k) {
    mesh.triangles.push_back({k, (k + 1) % 4, 4});
    mesh.triangles.push_back({(k + 1) % 4, k, 5});
  }
  const hydro::Waterplane cut = hydro::waterplane(mesh, Mat3::Identity(), Vec3::Zero(), 0);
  EXPECT_NEAR(cut.area, 2, 1e-15);
  EXPECT_NEAR(cut.xx, 1.0 / 3, 1e-15);
  EXPECT_NEAR(cut.yy, 1.0 / 3, 1e-15);
  EXPECT_LT(cut.centroid.norm(), 1e-15);
}

TEST(Waterplane, NothingWithoutACut) {
  const geometry::TriangleMesh box = geometry::box_shape({1, 1, 1}).surface;
  EXPECT_EQ(hydro::waterplane(box, Mat3::Identity(), {0, 0, 2}, 0).area, 0);
  EXPECT_EQ(hydro::waterplane(box, Mat3::Identity(), {0, 0, -2}, 0).area, 0);
}

/// The slope is dV/dz = -A_w, by central differences on a hull: second-order in 1e-5, so 1e-8.
TEST(Waterplane, IsTheSlopeOfTheVolume) {
  const geometry::TriangleMesh hull = lofted_hull();
  RandomStream random(7, "slope");
  for (int k = 0; k < 20; ++k) {
    const Mat3 R = test::random_attitude(random).toRotationMatrix();
    const Vec3 p(0, 0, 0.2 * random.uniform(-1, 1)), d(0, 0, 1e-5);
    const double slope =
        (hydro::submerged_mesh(hull, R, p + d, 0).volume - hydro::submerged_mesh(hull, R, p - d, 0).volume) / 2e-5;
    EXPECT_NEAR(hydro::waterplane(hull, R, p, 0).area, -slope, 1e-8 * -slope);
  }
}

}  // namespace waterplane_test

}  // namespace nilas::water_test
