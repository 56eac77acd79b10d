#pragma once
/// Ice that is inside a hull through a floe's whole thickness, so that it was crushed and squeezed out.
#include <vector>

#include "fracture/crush/contact_area.h"

namespace nilas::fracture {

/// The convex counter-clockwise polygon, in the floe's frame, of the points whose column from -thickness/2 to
/// thickness/2 is inside a convex part of a hull. It keeps at least `strip` [m] in the plane from the faces that are
/// surface of the hull (`is_outer` per face). The hull's faces in the ice thus stay in ice when the polygon is cut out.
/// Across the other faces, where another part of the hull follows, the polygon reaches to `strip` beyond the columns
/// that the face cuts. The polygons of both parts then overlap. The polygon is clipped to the box from `low` to `high`,
/// and may be empty.
std::vector<Vec2> columns_inside(const geometry::ConvexPolytope& part, const std::vector<char>& is_outer,
                                 const Placement& hull_in_floe, double thickness, double strip, const Vec2& low,
                                 const Vec2& high);

/// Ice of a floe whose place hulls have taken: convex polygons in the floe's frame.
struct CrushedIce {
  std::vector<std::vector<Vec2>> columns;   ///< Ice inside hulls through the whole thickness (columns_inside).
  std::vector<std::vector<Vec2>> sections;  ///< Sections of the hulls at mid thickness, up to their surfaces.
};
/// The area that convex polygons together have within an outline.
struct ColumnArea {
  double area = 0;               ///< [m^2]
  double outside = 0;            ///< Area of the polygons beyond the outline [m^2].
  Vec2 centroid = Vec2::Zero();  ///< Centroid of `area` [m].
};
ColumnArea column_area(const std::vector<std::vector<Vec2>>& columns, const std::vector<Vec2>& outline);
/// The polygons, grouped by overlap.
std::vector<std::vector<std::vector<Vec2>>> connected(const std::vector<std::vector<Vec2>>& columns);
/// The number of times that the outline enters a convex polygon.
int times_inside(const std::vector<Vec2>& column, const std::vector<Vec2>& outline);
/// Removes corners with a new edge (`is_new`) that are straight within 1e-9 of `size` [m], or that stick out by less
/// than `least` [m]. The edge in a corner's place counts as new. Changes nothing where the outline would not stay
/// simple. Returns whether it removed any corner.
bool trim_corners(std::vector<Vec2>& outline, std::vector<bool>& is_new, double least, double size);
/// Whether a piece that was cut along the outlines of the columns is squeezed out. It is where it lies within the
/// columns, or between the columns of different parts but wholly within the sections.
bool is_squeezed_out(const CrushedIce& ice, const std::vector<Vec2>& piece);

/// A flag per face of each part: whether the face, or a piece of it, is among `faces`, the hull's surface.
std::vector<std::vector<char>> outer_faces(const std::vector<geometry::ConvexPolytope>& parts,
                                           const std::vector<HullFace>& faces);

}  // namespace nilas::fracture
