#pragma once
/// Finds which part of a convex part's surface lies inside or against other parts of its body. Two parts that touch or
/// overlap are one solid, and what lies between them is no surface.
#include <memory>
#include <vector>

#include "core/base/math.h"

namespace nilas::detect {

struct FacetedGeometry;
struct Part;
struct PartCover;

/// Another part of the same body, in the body's frame.
struct CoveringPart {
  std::size_t index = 0;  ///< index within the body
  const FacetedGeometry* facets = nullptr;
  Vec3 centre = Vec3::Zero();
  double radius = 0;               ///< bounding radius about `centre` [m]
  const PartCover* own = nullptr;  ///< cover of that part; it lives as long as the body's parts

  bool contains(const Vec3& x, double tolerance) const;
  /// Returns whether x, inside the part, is nearer than `depth` [m] to a place where the part's surface is also the
  /// body's.
  bool leads_out_within(double depth, const Vec3& x) const;
};

/// The other parts near one part of a body. Points and directions are in the body's frame.
struct PartCover {
  std::vector<CoveringPart> parts;
  double tolerance = 0;  ///< parts nearer to each other than this touch [m]
  /// Marks the faces that lie wholly inside or against other parts.
  std::vector<char> face_is_internal;
  /// Marks the edges of which no direction between the normals of their faces leads out of the body, at any point.
  std::vector<char> edge_is_internal;
  /// Marks the vertices at which at most one edge is not internal. The body's edge, or its face, continues through such
  /// a vertex.
  std::vector<char> vertex_is_internal;

  /// Returns whether a contact of the part at its surface point x with outward unit normal n is none of the body. This
  /// holds where a part that contains x reaches farther along n. Otherwise n is a normal of the union of all parts at
  /// x: the union's proximal normal cone is the intersection of the cones of the parts that contain x.
  bool hides(const Vec3& x, const Vec3& n) const;
  /// Lists the parts for which hides() holds.
  void list_hiding(const Vec3& x, const Vec3& n, std::vector<const CoveringPart*>& out) const;
};

/// Returns the convex pieces of a part's face that are surface of the body, counter-clockwise from outside, in the
/// body's frame. What lies inside or against other parts is left out. For a part that stands alone it is the face
/// itself.
std::vector<std::vector<Vec3>> shown_pieces(const Part& part, std::size_t face);

/// Gives each of a body's parts its cover; parts that stand alone get none.
void cover_each_other(std::vector<Part>& parts);

}  // namespace nilas::detect
