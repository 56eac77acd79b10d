#include "core/output/vtk/body_surface.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/core/output/sample_run.h"

namespace nilas::output {
namespace body_surface_test {

/// Volume by signed cones from the origin over each polygon's fan; also checks that every edge has its opposite.
double closed_volume(const PolygonSurface& surface) {
  std::map<std::pair<int, int>, int> edges;
  double volume = 0;
  int begin = 0;
  for (const int end : surface.ends) {
    for (int k = begin; k < end; ++k) {
      const auto corner = [&](int i) { return surface.corners[i]; };
      const int a = corner(k), b = corner(k + 1 < end ? k + 1 : begin);
      ++edges[{a, b}];
      const auto point = [&](int i) { return surface.points[i]; };
      volume += point(corner(begin)).dot(point(a).cross(point(b))) / 6;
    }
    begin = end;
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  return volume;
}

TEST(BodySurface, APrismIsBottomTopAndSides) {
  const PolygonSurface surface = polygon_surface(test::triangle_floe());
  EXPECT_EQ(surface.points.size(), 6u);
  EXPECT_EQ(surface.ends, (std::vector<std::int32_t>{3, 6, 10, 14, 18}));
  EXPECT_NEAR(closed_volume(surface), 0.5 * 0.2, 1e-15);
}

TEST(BodySurface, AConcavePrismIsClosedToo) {
  geometry::Shape shape = test::triangle_floe();
  shape.outline = {Vec2(0, 0), Vec2(2, 0), Vec2(2, 2), Vec2(1, 0.5), Vec2(0, 2)};
  EXPECT_NEAR(closed_volume(polygon_surface(shape)), (4 - 1.5) * 0.2, 1e-15);
}

TEST(BodySurface, AMeshKeepsItsTriangles) {
  const PolygonSurface surface = polygon_surface(test::tetrahedron());
  EXPECT_EQ(surface.ends.size(), 4u);
  EXPECT_NEAR(closed_volume(surface), 1.0 / 6, 1e-15);
}

TEST(BodySurface, ASphereIsClosedAndOutward) {
  geometry::Shape shape;
  shape.kind = geometry::ShapeKind::sphere;
  shape.radius = 2;
  const double exact = 4 * k_pi / 3 * 8, volume = closed_volume(polygon_surface(shape));
  EXPECT_LT(volume, exact);
  EXPECT_GT(volume, 0.95 * exact);
}

TEST(BodySurface, APlaneHasNone) {
  geometry::Shape shape;
  shape.kind = geometry::ShapeKind::plane;
  EXPECT_TRUE(polygon_surface(shape).ends.empty());
}

}  // namespace body_surface_test
}  // namespace nilas::output
