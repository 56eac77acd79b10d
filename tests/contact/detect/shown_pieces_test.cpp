/// Tests of the visible regions of the faces of a body of several convex pieces.
#include <gtest/gtest.h>

#include "contact/detect/broad/part.h"
#include "contact/detect/broad/part_cover.h"
#include "tests/contact/detect/bodies_of_tests.h"

namespace nilas::detect {
namespace shown_pieces_test {

double area_of(const std::vector<Vec3>& loop) {
  Vec3 twice = Vec3::Zero();
  for (std::size_t k = 2; k < loop.size(); ++k) twice += (loop[k - 1] - loop[0]).cross(loop[k] - loop[0]);
  return 0.5 * twice.norm();
}

geometry::ConvexPolytope moved(geometry::ConvexPolytope polytope, const Vec3& by) {
  for (Vec3& x : polytope.vertices) x += by;
  geometry::complete(polytope);
  return polytope;
}

/// Area of the surface of a body of these convex pieces, and a mean of its normals that vanishes for a closed surface.
std::pair<double, double> surface(const std::vector<geometry::ConvexPolytope>& parts) {
  bodies::Bodies bodies;
  bodies::BodySpec spec;
  geometry::Shape shape = geometry::box_shape(Vec3(4, 4, 4));
  shape.parts = parts;
  spec.shape = std::make_shared<const geometry::Shape>(std::move(shape));
  spec.mass = 1;
  bodies.add(spec);
  double area = 0;
  Vec3 sum = Vec3::Zero();
  for (const Part& part : make_parts(bodies, 0))
    for (std::size_t f = 0; f < part.facets->polytope->faces.size(); ++f)
      for (const auto& loop : shown_pieces(part, f)) {
        area += area_of(loop);
        sum += area_of(loop) * part.facets->polytope->normals[f];
      }
  return {area, sum.norm()};
}

/// Pieces touch within 1e-6 of the largest one's radius: strips 1.7e-6 m wide along 12 m of borders are left out.
constexpr double k_tolerance = 3e-5;  // [m^2]

TEST(ShownPieces, OfABoxAloneAreItsFaces) {
  const auto [area, sum] = surface({geometry::make_box(Vec3(1, 2, 3))});
  EXPECT_NEAR(area, 22, 1e-12);
  EXPECT_NEAR(sum, 0, 1e-12);
}

TEST(ShownPieces, OfABoxInTwoPartsAreThoseOfTheWhole) {
  const auto [area, sum] = surface({moved(geometry::make_box(Vec3(0.4, 2, 3)), Vec3(-0.3, 0, 0)),
                                    moved(geometry::make_box(Vec3(0.6, 2, 3)), Vec3(0.2, 0, 0))});
  EXPECT_NEAR(area, 22, 1e-12);
  EXPECT_NEAR(sum, 0, 1e-12);
}

TEST(ShownPieces, OfABoxOnALargerOneLeaveItsFootprintOut) {
  const auto [area, sum] =
      surface({geometry::make_box(Vec3(2, 2, 1)), moved(geometry::make_box(Vec3(1, 1, 1)), Vec3(0.2, 0, 1))});
  EXPECT_NEAR(area, 16 + 4, k_tolerance);
  EXPECT_NEAR(sum, 0, k_tolerance);
}

TEST(ShownPieces, OfBoxesThatOverlapLeaveOutWhatIsInside) {
  const auto [area, sum] =
      surface({geometry::make_box(Vec3(2, 1, 1)), moved(geometry::make_box(Vec3(1, 3, 0.5)), Vec3(0.3, 0, 0))});
  EXPECT_NEAR(area, 10 + 4 * 0.5 + 2 * (1 * 2), k_tolerance) << "two arms 1 m long, 1 m x 0.5 m across";
  EXPECT_NEAR(sum, 0, k_tolerance);
}

}  // namespace shown_pieces_test
}  // namespace nilas::detect
