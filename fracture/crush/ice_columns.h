#pragma once
/// Ice that stands inside a hull through a floe's whole thickness: crushed, and squeezed out.
#include <vector>

#include "fracture/crush/contact_area.h"

namespace nilas {

/// Convex counter-clockwise polygon, in the floe's frame, of the points whose column from -thickness/2 to thickness/2
/// lies inside a convex part of a hull, at least `strip` [m] away in the plane from those of its faces that are surface
/// of the hull (`is_outer` per face). Across the other faces, where the hull goes on in another part, it reaches to
/// `strip` beyond the columns that the face cuts, so that the polygons of both parts overlap. Within `low` to `high`;
/// empty where there is none. Faces of the hull that stand in the ice stay in it when this is cut out.
std::vector<Vec2> columns_inside(const ConvexPolytope& part, const std::vector<char>& is_outer,
                                 const Placement& hull_in_floe, double thickness, double strip, const Vec2& low,
                                 const Vec2& high);

/// Ice of a floe that hulls have taken the place of: convex polygons in its frame.
struct CrushedIce {
  std::vector<std::vector<Vec2>> columns;   ///< through the whole thickness, as columns_inside finds them
  std::vector<std::vector<Vec2>> sections;  ///< of the hulls at mid thickness, up to their surfaces
};
/// Area that convex polygons together have within an outline.
struct ColumnArea {
  double area = 0;               ///< [m^2]
  double outside = 0;            ///< of the polygons beyond the outline [m^2]
  Vec2 centroid = Vec2::Zero();  ///< of the area [m]
};
ColumnArea column_area(const std::vector<std::vector<Vec2>>& columns, const std::vector<Vec2>& outline);
/// The polygons in groups that overlap.
std::vector<std::vector<std::vector<Vec2>>> connected(const std::vector<std::vector<Vec2>>& columns);
/// How often the outline comes into a convex polygon.
int times_inside(const std::vector<Vec2>& column, const std::vector<Vec2>& outline);
/// Takes off corners that an edge of `is_new` touches where they are on a straight line (1e-9 of `size`), or stick out
/// by less than `least` [m]; the edge in a corner's place is new. Leaves all as it is where that would not stay simple.
/// Returns whether it took any.
bool trim_corners(std::vector<Vec2>& outline, std::vector<bool>& is_new, double least, double size);
/// Whether a piece that was cut along the columns' outlines goes: it is within them, or, between the columns of
/// different parts, wholly within the sections.
bool is_squeezed_out(const CrushedIce& ice, const std::vector<Vec2>& piece);

/// Per face of each part: whether it is, or has pieces that are, among `faces`, the hull's surface.
std::vector<std::vector<char>> outer_faces(const std::vector<ConvexPolytope>& parts,
                                           const std::vector<HullFace>& faces);

}  // namespace nilas
