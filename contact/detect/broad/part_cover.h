#pragma once
/// Which of a part's surface lies inside or against other parts of its body: two parts that touch or overlap are one
/// solid, and what is between them is no surface.
#include <memory>
#include <vector>

#include "core/base/math.h"

namespace nilas {

struct FacetedGeometry;
struct Part;
struct PartCover;

/// Another part of the same body, in the body's frame.
struct CoveringPart {
  std::size_t index = 0;  ///< within the body
  const FacetedGeometry* facets = nullptr;
  Vec3 centre = Vec3::Zero();
  double radius = 0;               ///< about `centre` [m]
  const PartCover* own = nullptr;  ///< of that part; it lives as long as the body's parts

  bool contains(const Vec3& x, double tolerance) const;
  /// True where x, inside the part, is nearer than `depth` [m] to a place where its surface is one of the body.
  bool leads_out_within(double depth, const Vec3& x) const;
};

/// The other parts near one part of a body. Points and directions are in the body's frame.
struct PartCover {
  std::vector<CoveringPart> parts;
  double tolerance = 0;  ///< parts nearer to each other than this touch [m]
  /// Per face: wholly inside or against other parts.
  std::vector<char> face_is_internal;
  /// Per edge: no direction between the normals of its faces leads out of the body, at any of its points.
  std::vector<char> edge_is_internal;
  /// Per vertex: at most one edge at it is not internal. The body's edge, or its face, runs on through it.
  std::vector<char> vertex_is_internal;

  /// True where a contact of the part at its surface point x with outward unit normal n is none of the body: a part
  /// that contains x reaches farther along n. Otherwise n is a normal of the union of all parts at x (its proximal
  /// normal cone is the common part of the cones of the parts that hold x).
  bool hides(const Vec3& x, const Vec3& n) const;
  /// The same, as the parts that do it.
  void list_hiding(const Vec3& x, const Vec3& n, std::vector<const CoveringPart*>& out) const;
};

/// The convex pieces of a part's face, counter-clockwise from outside and in the body's frame, that are surface of the
/// body: what is inside or against other parts is left out. Of a part that stands alone the face itself.
std::vector<std::vector<Vec3>> shown_pieces(const Part& part, std::size_t face);

/// Gives each of a body's parts its cover; parts that stand alone get none.
void cover_each_other(std::vector<Part>& parts);

}  // namespace nilas
