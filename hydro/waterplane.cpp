#include "hydro/mesh_water.h"
#include "hydro/wetted.h"

namespace nilas::hydro {

namespace {

/// Moments of a plane region from its oriented boundary segments (Green), about a fixed origin.
struct BoundarySum {
  double area = 0, xx = 0, yy = 0, xy = 0;
  Vec2 first = Vec2::Zero();

  /// Adds the triangle of the origin and the segment a -> b, positive when counter-clockwise.
  void add(const Vec2& a, const Vec2& b) {
    constexpr double k_third = 1.0 / 3.0;  // centroid of a triangle
    constexpr double k_twelfth =
        1.0 / 12.0;  // second moments of a triangle with a corner at the origin: A/12 (a a + b b + (a+b)(a+b))
    const double triangle = 0.5 * (a.x() * b.y() - a.y() * b.x());
    const Vec2 sum = a + b;
    area += triangle;
    first += k_third * triangle * sum;
    const double weight = k_twelfth * triangle;
    xx += weight * (a.x() * a.x() + b.x() * b.x() + sum.x() * sum.x());
    yy += weight * (a.y() * a.y() + b.y() * b.y() + sum.y() * sum.y());
    xy += weight * (a.x() * a.y() + b.x() * b.y() + sum.x() * sum.y());
  }
};

}  // namespace

Waterplane waterplane(const geometry::TriangleMesh& mesh, const Mat3& R, const Vec3& p, double level) {
  const WaterPlane plane = water_plane(R, p, level);
  BoundarySum sum;
  Vec3 origin = Vec3::Zero();  // on the boundary, lest digits cancel for a solid far from the frame's origin
  bool found = false;
  MeshWater(mesh).for_each_cut(plane, [&](const CutTriangle& cut) {
    if (!found) origin = cut.leaves();
    found = true;
    // The cut closes the wet surface, so its boundary runs against the faces' own.
    sum.add((R * (cut.enters() - origin)).head<2>(), (R * (cut.leaves() - origin)).head<2>());
  });
  if (!(sum.area > 0)) return {};
  const Vec2 c = sum.first / sum.area;
  return {sum.area, (p + R * origin).head<2>() + c, sum.xx - sum.area * c.x() * c.x(),
          sum.yy - sum.area * c.y() * c.y(), sum.xy - sum.area * c.x() * c.y()};
}

}  // namespace nilas::hydro
