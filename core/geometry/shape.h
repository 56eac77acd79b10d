#pragma once
/// Geometry of a body in its own frame B, whose origin is the centre of mass.
#include <array>
#include <memory>
#include <vector>

#include "core/base/math.h"
#include "core/geometry/mesh.h"

namespace nilas::geometry {

/// Convex polytope with polygonal faces, in a body frame.
struct ConvexPolytope {
  std::vector<Vec3> vertices;           ///< [m]
  std::vector<std::vector<int>> faces;  ///< vertex loops, counter-clockwise from outside; coplanar triangles merged
  std::vector<Vec3> normals;            ///< outward unit normal per face
  std::vector<double> offsets;          ///< face plane: normal . x = offset [m]
  std::vector<std::vector<int>> vertex_faces;       ///< faces around each vertex
  std::vector<std::vector<int>> vertex_neighbours;  ///< vertices joined by an edge
  Vec3 centre = Vec3::Zero();                       ///< a point inside (mean of vertices) [m]
  double radius = 0;                                ///< largest distance from `centre` [m]
  double smallest_width = 0;  ///< smallest extent over the face normals: the thickness of a plate [m]
};

/// Fills normals, offsets, adjacency, centre, radius and width from vertices and faces. The offset is the largest over
/// the face's vertices.
void complete(ConvexPolytope& polytope);
/// Prism over a convex counter-clockwise outline, z from `bottom` to `top`. Vertices: bottom loop then top loop;
/// faces: bottom, top, then side i over edge (i, i+1).
ConvexPolytope make_prism(const std::vector<Vec2>& outline, double bottom, double top);
ConvexPolytope make_box(const Vec3& size);
/// Makes a polytope from a closed outward mesh whose surface is convex within `tolerance` [m]: no vertex is farther
/// than that outside a face, apart from the tilt of faces by rounded vertices. Neighbours coplanar within a twentieth
/// of it become one face, and vertices along a straight edge of two faces are left out. Throws InputError if not
/// closed, outward and convex.
ConvexPolytope make_polytope(const TriangleMesh& mesh, double tolerance);

enum class ShapeKind { prism, box, sphere, cylinder, plane, mesh };

/// Shape of one body. Which members are filled depends on `kind`.
struct Shape {
  ShapeKind kind = ShapeKind::box;
  std::vector<ConvexPolytope> parts;  ///< contact geometry of prism, box, mesh: convex parts
  std::vector<Vec2> outline;          ///< prism: counter-clockwise about the centroid [m]
  double thickness = 0;               ///< prism [m]
  double radius = 0;                  ///< sphere, cylinder [m]
  double half_height = 0;             ///< cylinder, axis z [m]
  TriangleMesh surface;        ///< closed outward surface of box, mesh, prism, cylinder (faceted), for water and output
  double bounding_radius = 0;  ///< radius of pieces and surface about the body origin; infinite for a plane [m]
  double smallest_width = 0;   ///< of the solid, without needles: what goes less than half of it cannot pass [m]
};

/// Floe: simple counter-clockwise outline, convex or concave, about its own centroid (the shape of a body must lie
/// about its centre of mass; this is not checked here). Vertices where the outline is straight stay in `outline` and
/// `surface` but make no faces of the parts. Throws InputError (outline) or ContractError (thickness not positive).
Shape prism_shape(const std::vector<Vec2>& outline, double thickness);
Shape box_shape(const Vec3& size);
Shape sphere_shape(double radius);
/// Axis z. The faceted surface has 64 sides and the cylinder's own volume, so that it floats at the right draught.
Shape cylinder_shape(double radius, double height);
/// Half space below z = 0 of its frame; outward normal +z.
Shape plane_shape();
/// Mesh whose vertices are already relative to the centre of mass. `parts`: convex parts in the same frame.
Shape mesh_shape(TriangleMesh surface, std::vector<ConvexPolytope> parts);

}  // namespace nilas::geometry
