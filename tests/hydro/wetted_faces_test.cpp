#include <gtest/gtest.h>

#include "hydro/sphere_surface.h"
#include "hydro/wetted.h"
#include "tests/hydro/solids.h"
#include "tests/support/random_vectors.h"

namespace nilas::water_test {

namespace wetted_faces_test {

/// Hydrostatic pressure per rho g is linear, so its integral over a plane face is the value at the centroid times the
/// area: sum of (z - level) A n over all wet faces must be the displaced volume upwards, with no horizontal part.
Vec3 pressure_sum(const std::vector<hydro::WettedFace>& faces, double level) {
  Vec3 sum = Vec3::Zero();
  for (const auto& face : faces) sum += (face.centroid.z() - level) * face.area * face.normal;
  return sum;
}

/// The wet faces and the cut close the wet solid: sum of A n is minus the waterplane area, straight up.
Vec3 area_sum(const std::vector<hydro::WettedFace>& faces) {
  Vec3 sum = Vec3::Zero();
  for (const auto& face : faces) sum += face.area * face.normal;
  return sum;
}

double total_area(const std::vector<hydro::WettedFace>& faces) {
  double sum = 0;
  for (const auto& face : faces) sum += face.area;
  return sum;
}

TEST(WettedFaces, PressureOverTheFacesIsTheBuoyancy) {
  for (const Solid& solid : solids()) {
    RandomStream random(5, solid.name);
    for (int k = 0; k < 200; ++k) {
      const Mat3 R = test::random_attitude(random).toRotationMatrix();
      const Vec3 p = Vec3(7, -9, 0.25 + solid.size * random.uniform(-1, 1)) - R * solid.mesh.vertices[0];
      std::vector<hydro::WettedFace> faces;
      hydro::wetted_faces(solid.mesh, R, p, 0.25, faces);
      const double volume = hydro::submerged_mesh(solid.mesh, R, p, 0.25).volume;
      const double area = total_area(faces);
      EXPECT_LE((pressure_sum(faces, 0.25) - Vec3(0, 0, volume)).norm(), 1e-10 * volume) << solid.name;
      const double cut = hydro::waterplane(solid.mesh, R, p, 0.25).area;
      EXPECT_LE((area_sum(faces) + Vec3(0, 0, cut)).norm(), 1e-11 * (area + cut)) << solid.name;
      for (const auto& face : faces) {
        EXPECT_LE(face.centroid.z(), 0.25 + 1e-12);
        EXPECT_NEAR(face.normal.norm(), 1, 1e-14);
      }
    }
  }
}

TEST(WettedFaces, FloeFacesGiveTheBuoyancyAndTheAreaOfTheirMesh) {
  for (const auto& outline : {concave_outline(), forked_outline()})
    for (const double thickness : {0.05, 0.5, 3.0}) {
      const geometry::Shape shape = geometry::prism_shape(outline, thickness);
      const hydro::PrismWater floe(shape);
      RandomStream random(6, std::to_string(thickness));
      for (int k = 0; k < 300; ++k) {
        const Mat3 R(k % 2 == 0 ? test::random_attitude(random).toRotationMatrix()
                                : Mat3(Eigen::AngleAxisd(0.01 * thickness, test::random_vector(random).normalized())));
        const Vec3 p(7, -9, (k % 2 == 0 ? 2 : 0.6 * thickness) * random.uniform(-1, 1));
        std::vector<hydro::WettedFace> faces, triangles;
        floe.wetted_faces(R, p, 0, faces);
        hydro::wetted_faces(shape.surface, R, p, 0, triangles);
        ASSERT_LE(faces.size(), outline.size() + 2);
        const double area = total_area(triangles), volume = hydro::submerged_mesh(shape.surface, R, p, 0).volume;
        EXPECT_NEAR(total_area(faces), area, 1e-12 * area);
        EXPECT_LE((pressure_sum(faces, 0) - Vec3(0, 0, volume)).norm(), 1e-10 * volume);
      }
    }
}

/// Cube of side 2 with its centre in the water: bottom 4 at depth 1, four sides of 2 at depth 1/2; no top.
TEST(WettedFaces, HalfSunkCube) {
  std::vector<hydro::WettedFace> faces;
  hydro::PrismWater(geometry::prism_shape({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 2))
      .wetted_faces(Mat3::Identity(), {5, 0, 0}, 0, faces);
  ASSERT_EQ(faces.size(), 5u);
  EXPECT_EQ(faces[0].area, 4);
  EXPECT_EQ(faces[0].centroid, Vec3(5, 0, -1));
  EXPECT_EQ(faces[0].normal, Vec3(0, 0, -1));
  EXPECT_NEAR(faces[1].area, 2, 1e-15);
  EXPECT_LT((faces[1].centroid - Vec3(5, -1, -0.5)).norm(), 1e-15);
  EXPECT_EQ(faces[1].normal, Vec3(0, -1, 0));
}

/// A face in the plane: dry when the solid stands on it or is cut there, wet once the solid hangs below it.
TEST(WettedFaces, FaceInThePlane) {
  const geometry::TriangleMesh box = geometry::box_shape({2, 2, 2}).surface;
  const auto area = [&](double z) {
    std::vector<hydro::WettedFace> faces;
    hydro::wetted_faces(box, Mat3::Identity(), {0, 0, z}, 0, faces);
    return total_area(faces);
  };
  EXPECT_EQ(area(1), 0);
  EXPECT_EQ(area(0), 12);
  EXPECT_EQ(area(-1), 24);
}

TEST(WettedFaces, AppendsToTheList) {
  std::vector<hydro::WettedFace> faces(3);
  hydro::wetted_faces(geometry::box_shape({1, 1, 1}).surface, Mat3::Identity(), {0, 0, -9}, 0, faces);
  EXPECT_EQ(faces.size(), 3u + 12u);
}

/// The faces are closed and outward, with the sphere's area. Their volume is 0.4 % less than the sphere's.
TEST(WettedFaces, FacetedSphere) {
  const geometry::TriangleMesh mesh = hydro::sphere_surface(0.5);
  std::vector<hydro::WettedFace> faces;
  hydro::wetted_faces(mesh, Mat3::Identity(), {0, 0, -9}, 0, faces);
  EXPECT_EQ(faces.size(), 512u);
  EXPECT_NEAR(total_area(faces), k_pi, 1e-13);
  EXPECT_LT(area_sum(faces).norm(), 1e-14);
  const double volume = pressure_sum(faces, 0).z() / (k_pi / 6);
  EXPECT_GT(volume, 0.995);
  EXPECT_LT(volume, 1);
}

}  // namespace wetted_faces_test

}  // namespace nilas::water_test
