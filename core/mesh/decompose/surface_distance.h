#pragma once
/// Largest distances from triangles to a surface, by branch and bound.
#include <limits>
#include <memory>

#include "core/mesh/decompose/decompose.h"

namespace nilas {

/// Corners of a triangle [m].
using Corners = std::array<Vec3, 3>;

/// Its triangles by their corners, wound as they are [m].
std::vector<Corners> corners_of(const TriangleMesh& mesh);

/// How exactly the largest distance over all points of some triangles is sought.
struct DistanceSearch {
  double precision = 0;       ///< above 0: the largest may be this much larger than found [m]
  bool outside_only = false;  ///< leave out points inside the surface, which then must be closed
  double floor = 0;           ///< whatever is below is as good as 0 [m]
  double slack = 0;           ///< share of the largest found that it may be larger
  double ceiling = std::numeric_limits<double>::infinity();  ///< stop once the largest exceeds this [m]
};

/// Distances from a fixed set of triangles.
class SurfaceDistance {
 public:
  /// Triangles without area are left out; at least one must have an area.
  explicit SurfaceDistance(std::vector<Corners> surface);
  ~SurfaceDistance();
  SurfaceDistance(const SurfaceDistance&) = delete;
  SurfaceDistance& operator=(const SurfaceDistance&) = delete;

  /// Of a point from the surface [m].
  double at(const Vec3& p) const;
  /// The same of a point outside a closed surface; 0 inside [m].
  double outside(const Vec3& p) const;
  /// What of the triangles lies further than `skin` [m] from every face of the surface in the same plane.
  std::vector<Corners> without_shared_faces(const std::vector<Corners>& triangles, double skin) const;
  /// The largest distance from the surface of any point of the triangles, by halving those that may hold a larger one;
  /// `unmeasured` is how much larger it may be. What some millions of halvings leave open is counted there too.
  Deviation largest(const std::vector<Corners>& triangles, const DistanceSearch& search) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace nilas
