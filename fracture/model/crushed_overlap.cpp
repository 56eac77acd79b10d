/// The overlap of hulls with the ice that they crushed.
#include <algorithm>

#include "fracture/model/crushing.h"

namespace nilas::fracture {

namespace {

/// The depth of a point inside a part, measured to the part's outer faces [m]; 0 outside it or where it has none.
double depth_in(const geometry::ConvexPolytope& part, const std::vector<char>& outer, const Vec3& x) {
  double way_out = -1;
  for (std::size_t f = 0; f < part.normals.size(); ++f) {
    const double inside = part.offsets[f] - part.normals[f].dot(x);
    if (inside <= 0) return 0;
    if (outer[f] != 0 && (way_out < 0 || inside < way_out)) way_out = inside;
  }
  return std::max(0.0, way_out);
}

double deepest_corner(const CrushingSurface& hull, const Placement& floe_in_hull, const geometry::Shape& floe) {
  double deepest = 0;
  for (std::size_t k = 0; k < hull.parts.size(); ++k) {
    const geometry::ConvexPolytope& part = hull.parts[k];
    if ((floe_in_hull.p - part.centre).norm() > part.radius + floe.bounding_radius) continue;
    for (const Vec2& corner : floe.outline)
      for (const double z : {-0.5 * floe.thickness, 0.5 * floe.thickness}) {
        const Vec3 x = floe_in_hull.R * Vec3(corner.x(), corner.y(), z) + floe_in_hull.p;
        if ((x - part.centre).squaredNorm() <= part.radius * part.radius)
          deepest = std::max(deepest, depth_in(part, hull.outer[k], x));
      }
  }
  return deepest;
}

}  // namespace

double Crushing::deepest_overlap(const bodies::Bodies& bodies) const {
  double deepest = 0;
  for (const CrushingSurface& hull : hulls_)
    for (int floe = 0; floe < bodies.size(); ++floe) {
      if (!ice_.is_breakable(floe) || !may_meet(bodies, hull, floe, 0)) continue;
      const auto k = static_cast<std::size_t>(hull.body), b = static_cast<std::size_t>(floe);
      const Mat3 to_hull = bodies.R_GB[k].transpose();
      deepest = std::max(deepest,
                         deepest_corner(hull, {to_hull * bodies.R_GB[b], to_hull * (bodies.p_GB[b] - bodies.p_GB[k])},
                                        *bodies.shape[b]));
    }
  return deepest;
}

}  // namespace nilas::fracture
