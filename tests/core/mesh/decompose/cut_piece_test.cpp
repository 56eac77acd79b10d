/// Cuts by a plane: closed pieces that hold the whole volume.
#include <gtest/gtest.h>

#include <random>

#include "core/mesh/decompose/pieces.h"
#include "core/mesh/mend/mend.h"
#include "tests/core/mesh/hull_shapes.h"

namespace nilas::mesh {
namespace cut_piece_test {

/// Volumes of the pieces, each a sound solid, the least first.
std::vector<double> volumes(const geometry::TriangleMesh& mesh, const HalfSpace& plane) {
  std::vector<double> found;
  for (const auto& piece : cut(mesh, plane)) {
    EXPECT_TRUE(geometry::find_defects(piece).sound()) << geometry::find_defects(piece).text();
    found.push_back(geometry::signed_volume(piece));
  }
  std::sort(found.begin(), found.end());
  return found;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected, double error) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], error) << k;
}

TEST(CutPiece, ABoxAlongAndAcrossAndAside) {
  const geometry::TriangleMesh box = box_mesh({0, 0, 0}, {4, 1, 1});
  expect_near(volumes(box, {Vec3::UnitX(), 1}), {1, 3}, 1e-12);
  expect_near(volumes(box, {Vec3(1, 0, 1).normalized(), 2.5 / std::sqrt(2.0)}), {2, 2}, 1e-12);
  EXPECT_TRUE(cut(box, {Vec3::UnitX(), 5}).empty());
  EXPECT_TRUE(cut(box, {Vec3::UnitX(), 4}).empty()) << "the plane of a face";
}

TEST(CutPiece, CapsHaveHolesAndSidesFallApart) {
  const geometry::TriangleMesh barge = moonpool_mesh();  // its well from x = 1.5 to 2.5
  expect_near(volumes(barge, {Vec3::UnitZ(), 0.2}), {k_moonpool_volume / 3, 2 * k_moonpool_volume / 3}, 1e-12);
  expect_near(volumes(barge, {Vec3::UnitY(), 0}), {k_moonpool_volume / 2, k_moonpool_volume / 2}, 1e-12);
  // through the well, and through its wall: on one side two arms and a block
  expect_near(volumes(barge, {Vec3::UnitX(), 2}), {k_moonpool_volume / 2, k_moonpool_volume / 2}, 1e-12);
  expect_near(volumes(barge, {Vec3::UnitX(), 1.5}), {0.9, k_moonpool_volume - 0.9}, 1e-12);
  expect_near(volumes(barge, {Vec3::UnitY(), 0.25}), {0.6, k_moonpool_volume - 0.6}, 1e-12);
}

TEST(CutPiece, FacesInThePlaneMakeNeitherSliversNorMembranes) {
  const double column = column_area(0.22, 16), pontoon = 3.0 * 0.6 * 0.3, deck = 2.8 * 2.8 * 0.2;
  const MendedMesh platform = mend(soup_of(semisubmersible_shells(16)), {3e-5, 0.15});
  ASSERT_TRUE(platform.open.empty());
  std::mt19937 random(7);
  // The cases are the solid as drawn, and with every coordinate moved by the rounding of float32.
  for (const double moved : {0.0, 1.2e-7}) {
    geometry::TriangleMesh mesh = platform.mesh;
    std::uniform_real_distribution<double> off(-moved, moved);
    for (auto& p : mesh.vertices)
      if (moved > 0) p += Vec3(off(random), off(random), off(random));
    expect_near(volumes(mesh, {Vec3::UnitZ(), static_cast<float>(0.3)}), {pontoon, pontoon, 4 * column * 0.7 + deck},
                1e-5);
    const double lower = pontoon + 2 * column * 0.7;
    expect_near(volumes(mesh, {Vec3::UnitZ(), 1}), {lower, lower, deck}, 1e-5);
  }
}

TEST(CutPiece, FineAndCurvedSolidsKeepTheirVolume) {
  const geometry::TriangleMesh ship = geometry::rounded_to_float(ship_mesh(60, 20)),
                               bulb = bulb_mesh({0, 0, 0}, {2, 0.5, 0.3}, 20);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(-1, 1);
  for (const auto& mesh : {ship, bulb})
    for (int n = 0; n < 40; ++n) {
      const Vec3 normal = Vec3(part(random), part(random), part(random)).normalized();
      const Vec3& through = mesh.vertices[random() % mesh.vertices.size()];
      double sum = 0;
      for (const double volume : volumes(mesh, {normal, normal.dot(through)})) sum += volume;
      EXPECT_NEAR(sum, geometry::signed_volume(mesh), 1e-6 * geometry::signed_volume(mesh)) << n;
    }
}

}  // namespace cut_piece_test
}  // namespace nilas::mesh
