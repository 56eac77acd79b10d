#include <gtest/gtest.h>

#include "hydro/wetted.h"
#include "tests/hydro/solids.h"
#include "tests/hydro/tetrahedron_oracle.h"
#include "tests/support/random_vectors.h"
#include "tests/support/tetrahedron.h"

namespace nilas::water_test {

namespace submerged_test {

constexpr double k_exact = 1e-10;

/// Compares the relative error of the volume, and the error of the centre over the solid's size.
void expect_same(const hydro::Submerged& wet, const LongSolid& oracle, const Vec3& p, double size,
                 const std::string& what) {
  const double volume = static_cast<double>(oracle.volume);
  EXPECT_NEAR(wet.volume, volume, k_exact * volume) << what;
  if (volume == 0) {
    EXPECT_EQ(wet.centre, p) << what;
    return;
  }
  const Vec3 arm = (oracle.moment / oracle.volume).cast<double>();
  EXPECT_LT((wet.centre - p - arm).norm(), k_exact * size) << what;
}

void compare_at(const Solid& solid, const Mat3& R, double height, double level) {
  Vec3 middle = Vec3::Zero();
  for (const auto& x : solid.mesh.vertices) middle += x / static_cast<double>(solid.mesh.vertices.size());
  const Vec3 p = Vec3(3, -5, level + height) - R * middle;
  expect_same(hydro::submerged_mesh(solid.mesh, R, p, level), submerged_oracle(solid.mesh, R, p, level), p, solid.size,
              solid.name + " at height " + std::to_string(height));
}

/// 200 attitudes and heights per solid, from dry to wholly submerged.
TEST(Submerged, RandomAttitudesMatchSignedTetrahedra) {
  for (const Solid& solid : solids()) {
    ASSERT_TRUE(geometry::find_defects(solid.mesh).sound()) << solid.name;
    RandomStream random(1, solid.name);
    for (int k = 0; k < 200; ++k)
      compare_at(solid, test::random_attitude(random).toRotationMatrix(), solid.size * random.uniform(-1, 1), 0.37);
  }
}

TEST(Submerged, LevelTiltedSixtyDegreesAndCapsized) {
  for (const Solid& solid : solids())
    for (const double degrees : {0.0, 60.0, 90.0, 180.0})
      for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.6, 0.8, 0)})
        for (const double height : {-0.3, 0.0, 0.1})
          compare_at(solid, Eigen::AngleAxisd(degrees * k_deg, axis).toRotationMatrix(), height, 0);
}

/// The plate is far from the ground origin and at a depth of 10^5 times its thickness.
TEST(Submerged, DeepAndFarFromTheOrigin) {
  const Solid plate{"plate", geometry::box_shape({10, 8, 0.01}).surface, 5};
  RandomStream random(2, "deep");
  for (int k = 0; k < 50; ++k) {
    const Mat3 R = test::random_attitude(random).toRotationMatrix();
    const hydro::Submerged wet = hydro::submerged_mesh(plate.mesh, R, {4000, -3000, -1000}, 0);
    EXPECT_NEAR(wet.volume, 0.8, k_exact * 0.8);
    EXPECT_LT((wet.centre - Vec3(4000, -3000, -1000)).norm(), k_exact * plate.size);
  }
}

/// Tetrahedron with a corner at the origin and unit legs along the axes: V = 1/6, the part below height z is
/// (1 - (1 - z)^3) / 6. All coordinates are exact, so vertices, edges and faces lie in the plane to the last bit.
TEST(Submerged, VertexEdgeOrFaceExactlyOnThePlane) {
  const geometry::TriangleMesh corner = test::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  const Mat3 I = Mat3::Identity();
  const auto volume = [&](const Mat3& R, double z) { return hydro::submerged_mesh(corner, R, {0, 0, z}, 0).volume; };
  EXPECT_EQ(volume(I, 0), 0);                      // standing on the water by a face
  EXPECT_NEAR(volume(I, -1), 1.0 / 6, 1e-16);      // the top vertex on the plane
  EXPECT_NEAR(volume(I, -0.5), 7.0 / 48, 1e-16);   // cut half way up
  const Mat3 over = Vec3(1, -1, -1).asDiagonal();  // half a turn about x
  EXPECT_NEAR(volume(over, 0), 1.0 / 6, 1e-16);    // hanging from the water by a face
  EXPECT_EQ(volume(over, 1), 0);                   // touching it by a vertex from above
  Mat3 on_edge;                                    // z up along the body's -y: the edges at y = 0 on the plane
  on_edge << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  EXPECT_NEAR(volume(on_edge, 0), 1.0 / 6, 1e-16);
  // An edge in the plane between a wet and a dry vertex: half of the solid.
  const geometry::TriangleMesh halved = test::tetrahedron({-1, 0, 0}, {1, 0, 0}, {0, 1, 1}, {0, 1, -1});
  const hydro::Submerged wet = hydro::submerged_mesh(halved, I, Vec3::Zero(), 0);
  EXPECT_NEAR(wet.volume, 1.0 / 3, 1e-15);
  EXPECT_LT((wet.centre - Vec3(0, 0.5, -0.25)).norm(), 1e-15);
}

/// Every vertex in turn is set on the plane, as near as rounding allows.
TEST(Submerged, EachVertexOnThePlane) {
  for (const Solid& solid : solids()) {
    RandomStream random(3, solid.name);
    for (std::size_t v = 0; v < solid.mesh.vertices.size() && v < 40; ++v) {
      const Mat3 R = test::random_attitude(random).toRotationMatrix();
      const Vec3 p = -(R * solid.mesh.vertices[v]);
      const LongSolid oracle = submerged_oracle(solid.mesh, R, p, 0);
      const double total = geometry::mesh_properties(solid.mesh, 1).mass;
      if (oracle.volume < 1e-9 * total) continue;  // The vertex is the lowest one: only rounding is left.
      expect_same(hydro::submerged_mesh(solid.mesh, R, p, 0), oracle, p, solid.size, solid.name);
    }
  }
}

TEST(Submerged, DryAndWhollySubmerged) {
  for (const Solid& solid : solids()) {
    const geometry::MassProperties all = geometry::mesh_properties(solid.mesh, 1);
    const Mat3 R = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const Vec3 high(1, 2, 5000), low(1, 2, -5000);
    EXPECT_EQ(hydro::submerged_mesh(solid.mesh, R, high, 0).volume, 0);
    EXPECT_EQ(hydro::submerged_mesh(solid.mesh, R, high, 0).centre, high);
    const hydro::Submerged wet = hydro::submerged_mesh(solid.mesh, R, low, 0);
    EXPECT_NEAR(wet.volume, all.mass, k_exact * all.mass) << solid.name;
    EXPECT_LT((wet.centre - low - R * all.com).norm(), k_exact * solid.size) << solid.name;
  }
}

/// The floe's closed form and its polygon clipping are compared with the clipped triangles and the oracle.
TEST(Submerged, FloesMatchTheirMeshes) {
  for (const auto& outline : {concave_outline(), forked_outline()})
    for (const double thickness : {0.02, 0.4, 3.0}) {
      const geometry::Shape shape = geometry::prism_shape(outline, thickness);
      const hydro::PrismWater floe(shape);
      RandomStream random(4, std::to_string(thickness));
      for (int k = 0; k < 300; ++k) {
        // A third is level (caps uncut), a third tilted, a third at any attitude; some of each are capsized.
        const double tilt = k % 3 == 0 ? 0.1 * thickness * random.uniform() : random.uniform(0, k_pi);
        Mat3 R(Eigen::AngleAxisd(random.uniform(0, 7), Vec3::UnitZ()) * Eigen::AngleAxisd(tilt, Vec3::UnitX()) *
               Eigen::AngleAxisd(random.uniform(0, 7), Vec3::UnitZ()));
        if (k % 2 == 1) R = R * Vec3(1, -1, -1).asDiagonal();
        const Vec3 p(20, -30, 0.2 + (k % 3 == 0 ? 0.3 * thickness : 2) * random.uniform(-1, 1));
        const hydro::Submerged wet = floe.submerged(R, p, 0.2);
        expect_same(wet, submerged_oracle(shape.surface, R, p, 0.2), p, 2, "floe");
        const hydro::Submerged mesh = hydro::submerged_mesh(shape.surface, R, p, 0.2);
        EXPECT_NEAR(wet.volume, mesh.volume, k_exact * mesh.volume);
        EXPECT_LT((wet.centre - mesh.centre).norm(), 2 * k_exact);
      }
    }
}

/// Level floe at draught d: V = A d, the centre d/2 under water; its deck just awash counts in full.
TEST(Submerged, LevelFloe) {
  const geometry::Shape shape = geometry::prism_shape(concave_outline(), 0.5);
  const double area = geometry::polygon_moments(shape.outline).area;
  for (const double draught : {0.0, 0.1, 0.25, 0.5, 0.9}) {
    const double wet_part = std::min(draught, 0.5);
    const Vec3 p(1, 2, 0.25 - draught);
    const hydro::Submerged wet = hydro::PrismWater(shape).submerged(Mat3::Identity(), p, 0);
    EXPECT_NEAR(wet.volume, area * wet_part, 1e-14);
    const Vec3 centre = wet_part == 0 ? p : Vec3(1, 2, 0.5 * wet_part - draught);
    EXPECT_LT((wet.centre - centre).norm(), 1e-14) << draught;
  }
}

/// Half a sphere: V = 2/3 pi r^3, centre 3/8 r down. Against the sphere of revolution's integral at other draughts:
/// V = integral of pi (r^2 - s^2) ds, moment = integral of pi (r^2 - s^2) s ds over the wet s, by antiderivative.
TEST(Submerged, Sphere) {
  const double r = 0.7;
  const hydro::Submerged half = hydro::submerged_sphere(r, {1, 2, 3}, 3);
  EXPECT_NEAR(half.volume, 2.0 / 3 * k_pi * r * r * r, 1e-15);
  EXPECT_LT((half.centre - Vec3(1, 2, 3 - 3.0 / 8 * r)).norm(), 1e-15);
  for (const double z : {-2.0, -0.7, -0.5, 0.0, 0.3, 0.65, 0.7, 1.0}) {
    const double s = std::clamp(-z, -r, r);  // height of the surface over the centre
    const double volume = k_pi * (r * r * s - s * s * s / 3 + 2.0 / 3 * r * r * r);
    const double moment = k_pi * (r * r * s * s / 2 - s * s * s * s / 4 - r * r * r * r / 4);
    const hydro::Submerged wet = hydro::submerged_sphere(r, {0, 0, z}, 0);
    EXPECT_NEAR(wet.volume, volume, 1e-14) << z;
    EXPECT_NEAR(wet.volume * (wet.centre.z() - z), moment, 1e-14) << z;
  }
}

}  // namespace submerged_test

}  // namespace nilas::water_test
