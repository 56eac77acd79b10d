#include "core/geometry/shape.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/geometry/polygon.h"
#include "tests/core/bodies/solids.h"
#include "tests/support/about_centroid.h"

namespace nilas::geometry {
namespace shape_test {

double parts_volume(const Shape& shape) {
  double sum = 0;
  for (const auto& part : shape.parts) {
    TriangleMesh mesh{part.vertices, {}};
    for (const auto& loop : part.faces)
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) mesh.triangles.push_back({loop[0], loop[i], loop[i + 1]});
    sum += signed_volume(mesh);
  }
  return sum;
}

TEST(PrismShape, PartsAndSurfaceFillTheFloe) {
  RandomStream random(12, "floes");
  std::vector<std::vector<Vec2>> outlines{bodies::l_outline(), bodies::star_outline(6, 2, 0.7)};
  for (int i = 0; i < 100; ++i) outlines.push_back(bodies::random_star_polygon(random));
  for (const auto& raw : outlines) {
    const auto outline = test::about_centroid(raw);
    const Shape shape = prism_shape(outline, 0.25);
    const double volume = 0.25 * polygon_moments(outline).area;
    EXPECT_EQ(shape.kind, ShapeKind::prism);
    EXPECT_EQ(shape.outline, outline);
    EXPECT_EQ(shape.parts.size(), convex_pieces(outline).size());
    EXPECT_TRUE(find_defects(shape.surface).sound()) << find_defects(shape.surface).text();
    EXPECT_NEAR(signed_volume(shape.surface), volume, 1e-13 * volume);
    EXPECT_NEAR(parts_volume(shape), volume, 1e-12 * volume);
    double reach = 0;
    for (const auto& p : outline) reach = std::max(reach, std::hypot(p.norm(), 0.125));
    EXPECT_DOUBLE_EQ(shape.bounding_radius, reach);
  }
}

/// Straight vertices on every side, exact and rounded: no triangle without area, no further faces.
TEST(PrismShape, StraightVerticesMakeNeitherSliversNorFaces) {
  RandomStream random(13, "turns");
  for (int i = 0; i < 50; ++i) {
    const Eigen::Rotation2Dd R(i == 0 ? 0 : random.uniform(0, 2 * k_pi));
    std::vector<Vec2> outline;
    const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (std::size_t k = 0; k < 4; ++k)
      for (const double s : {0.0, 0.25, 0.5, 0.75})
        outline.push_back(R * (square[k] + s * (square[(k + 1) % 4] - square[k])));
    const Shape shape = prism_shape(test::about_centroid(outline), 0.1);
    EXPECT_TRUE(find_defects(shape.surface).sound()) << find_defects(shape.surface).text();
    EXPECT_NEAR(signed_volume(shape.surface), 0.1, 1e-15);
    ASSERT_EQ(shape.parts.size(), 1u);
    EXPECT_EQ(shape.parts[0].faces.size(), 6u);
    for (const auto& t : shape.surface.triangles) {
      const auto corner = [&](std::size_t k) -> Vec3 { return shape.surface.vertices[t[k]]; };
      EXPECT_GT((corner(1) - corner(0)).cross(corner(2) - corner(0)).norm(), 0.01);
    }
  }
}

/// Cracks that meet an old one under rounding leave ice without width between them.
TEST(PrismShape, ANeedleHasNoPart) {
  int without = 0;
  for (const double width : {1e-16, 1e-14, 1e-12, 1e-9, 1e-3}) {
    std::vector<Vec2> outline{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {0.2 + width, 0.5}, {0.6, 0.9}, {0, 0.3}, {-1, 0.5}};
    if (!is_simple(outline)) continue;
    const Shape shape = prism_shape(outline, 0.1);
    const double area = polygon_moments(outline).area;
    EXPECT_NEAR(parts_volume(shape), 0.1 * area, 1e-9 * area) << width;
    EXPECT_GE(shape.smallest_width, 1e-4);
    without += shape.parts.size() < convex_piece_indices(outline).size() ? 1 : 0;
  }
  EXPECT_GT(without, 0);
}

/// A floe that a bow broke out of a sheet of 40 mm, with a bay of four sides at one end. Its cuts leave slivers of 1.4
/// to 3.8 mm beside each other, and the narrowest ice behind an outer side has 8.3 mm.
TEST(PrismShape, IsAsWideAsTheIceBehindItsSlivers) {
  const std::vector<Vec2> outline{{-0.0701, 0.0832},  {-0.0701, -0.0912}, {-0.0394, -0.1089},
                                  {-0.0357, -0.1126}, {-0.0331, -0.1172}, {-0.0317, -0.1223},
                                  {-0.0317, -0.1249}, {0.1266, 0.0334},   {-0.0317, 0.0990}};
  const Shape floe = prism_shape(test::about_centroid(outline), 0.04);
  double thinnest = floe.thickness;
  for (const auto& part : floe.parts) thinnest = std::min(thinnest, part.smallest_width);
  EXPECT_NEAR(thinnest, 0.0014, 1e-4);
  EXPECT_NEAR(floe.smallest_width, 0.0083, 1e-4);
}

TEST(PrismShape, IsAsNarrowAsItsNarrowestStrip) {
  const auto with_strip = [](double from, double width) {
    return prism_shape(test::about_centroid({{0, 0}, {4, 0}, {4, width}, {from, width}, {from, 4}, {0, 4}}), 0.3);
  };
  EXPECT_DOUBLE_EQ(with_strip(1, 0.5).smallest_width, 0.3);
  // whether or not it lies before the middle of the longest side
  for (const double from : {0.5, 1.0, 2.5, 3.5}) EXPECT_NEAR(with_strip(from, 0.05).smallest_width, 0.05, 0.005);
  // what a notch leaves, and a strip that bends
  const Shape notched =
      prism_shape(test::about_centroid({{0, 0}, {10, 0}, {10, 4}, {9, 4}, {9, 0.05}, {7, 0.05}, {7, 4}, {0, 4}}), 0.3);
  EXPECT_NEAR(notched.smallest_width, 0.05, 0.005);
  const Shape bent = prism_shape(
      test::about_centroid({{0, 0}, {2, 0.01}, {4, 0}, {4, 0.05}, {2, 0.06}, {1, 0.055}, {1, 4}, {0, 4}}), 0.3);
  EXPECT_NEAR(bent.smallest_width, 0.05, 0.005);
}

/// Strips anywhere and in any direction on random floes are seen.
TEST(PrismShape, SeesStripsOnRandomFloes) {
  RandomStream random(14, "strips");
  for (int i = 0; i < 200; ++i) {
    const double from = random.uniform(0.2, 3.5), width = random.uniform(0.01, 0.1), tilt = random.uniform(-0.3, 0.3);
    std::vector<Vec2> outline{{0, 0}, {4, 0}, {4 + width * tilt, width}, {from, width}};
    for (double x = from + tilt, y = 1; y < 4; y += random.uniform(0.5, 1.5)) outline.emplace_back(x, y), x -= 0.1;
    outline.emplace_back(0, 4);
    if (!is_simple(outline)) continue;
    const Eigen::Rotation2Dd R(random.uniform(0, 2 * k_pi));
    for (auto& p : outline) p = R * p;
    EXPECT_NEAR(prism_shape(test::about_centroid(outline), 0.3).smallest_width, width, 0.2 * width) << i;
  }
}

TEST(PrismShape, WrongFloesAreRefused) {
  EXPECT_THROW(prism_shape(bodies::l_outline(), 0), ContractError);
  EXPECT_THROW(prism_shape({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, 1), InputError);
}

TEST(BoxShape, SurfaceAndPart) {
  const Shape shape = box_shape({2, 3, 4});
  EXPECT_TRUE(find_defects(shape.surface).sound());
  EXPECT_DOUBLE_EQ(signed_volume(shape.surface), 24);
  EXPECT_DOUBLE_EQ(parts_volume(shape), 24);
  EXPECT_DOUBLE_EQ(shape.bounding_radius, 0.5 * Vec3(2, 3, 4).norm());
  EXPECT_DOUBLE_EQ(shape.smallest_width, 2);
  EXPECT_THROW(box_shape({1, 0, 1}), ContractError);
}

TEST(CylinderShape, FacetedSurfaceHasTheCylindersVolume) {
  const Shape shape = cylinder_shape(0.4, 1.5);
  EXPECT_TRUE(find_defects(shape.surface).sound());
  EXPECT_EQ(shape.surface.vertices.size(), 128u);
  const double volume = k_pi * 0.16 * 1.5;
  EXPECT_NEAR(signed_volume(shape.surface), volume, 1e-13);
  const MassProperties exact = cylinder_properties(0.4, 1.5, volume), faceted = mesh_properties(shape.surface, 1);
  EXPECT_LE((faceted.inertia - exact.inertia).norm(), 1e-5 * exact.inertia.norm());
  EXPECT_LE(faceted.com.norm(), 1e-14);
  EXPECT_EQ(shape.radius, 0.4);
  EXPECT_EQ(shape.half_height, 0.75);
  EXPECT_NEAR(shape.bounding_radius, std::hypot(0.4, 0.75), 1e-3 * 0.4);
  for (const auto& p : shape.surface.vertices) EXPECT_LE(p.norm(), shape.bounding_radius);
  EXPECT_TRUE(shape.parts.empty());
}

TEST(OtherShapes, SphereAndPlane) {
  EXPECT_EQ(sphere_shape(0.3).radius, 0.3);
  EXPECT_EQ(sphere_shape(0.3).bounding_radius, 0.3);
  EXPECT_THROW(sphere_shape(-1), ContractError);
  EXPECT_EQ(plane_shape().kind, ShapeKind::plane);
  EXPECT_TRUE(std::isinf(plane_shape().bounding_radius));
}

TEST(MeshShape, BoundsSurfaceAndParts) {
  const TriangleMesh surface = bodies::moved(bodies::octahedron(), Mat3::Identity(), {2, 0, 0});
  const Shape shape = mesh_shape(surface, {make_box({1, 1, 1})});
  EXPECT_EQ(shape.kind, ShapeKind::mesh);
  EXPECT_EQ(shape.bounding_radius, 3);
  EXPECT_EQ(shape.surface.triangles.size(), 8u);
  EXPECT_EQ(shape.parts.size(), 1u);
  EXPECT_DOUBLE_EQ(mesh_shape(bodies::octahedron(), {make_box({4, 4, 4})}).bounding_radius, std::sqrt(12));
}

}  // namespace shape_test
}  // namespace nilas::geometry
