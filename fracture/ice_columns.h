#pragma once
/// Ice that stands inside a hull through a floe's whole thickness: crushed, and squeezed out.
#include <vector>

#include "fracture/contact_area.h"

namespace nilas {

/// Convex counter-clockwise polygon, in the floe's frame, of the points whose column from -thickness/2 to thickness/2
/// lies inside a convex part of a hull, at least `margin` [m] away in the plane from those of its faces that are
/// surface of the hull (`is_outer` per face). Within `low` to `high`; empty where there is none. Faces of the hull that
/// stand in the ice stay in it when this is cut out.
std::vector<Vec2> columns_inside(const ConvexPolytope& part, const std::vector<char>& is_outer,
                                 const Placement& hull_in_floe, double thickness, double margin, const Vec2& low,
                                 const Vec2& high);

/// Per face of each part: whether it is, or has pieces that are, among `faces`, the hull's surface.
std::vector<std::vector<char>> outer_faces(const std::vector<ConvexPolytope>& parts,
                                           const std::vector<HullFace>& faces);

}  // namespace nilas
