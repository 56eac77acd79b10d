#pragma once
/// Largest distances from triangles to a surface, by branch and bound.
#include <limits>
#include <memory>

#include "core/mesh/decompose/decompose.h"

namespace nilas::mesh {

/// Corners of a triangle [m].
using Corners = std::array<Vec3, 3>;

/// The triangles of a mesh by their corners, with their winding [m].
std::vector<Corners> corners_of(const geometry::TriangleMesh& mesh);

/// Settings of the search for the largest distance over all points of some triangles.
struct DistanceSearch {
  double precision = 0;       ///< if above 0, the result may be too small by this much [m]
  bool outside_only = false;  ///< leave out points inside the surface, which then must be closed
  double floor = 0;           ///< distances below this are not searched for [m]
  double slack = 0;           ///< the result may be too small by this share
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

  /// Distance of a point from the surface [m].
  double at(const Vec3& p) const;
  /// The same for a point outside a closed surface; 0 inside [m].
  double outside(const Vec3& p) const;
  /// The parts of the triangles farther than `skin` [m] from every face of the surface in the same plane.
  std::vector<Corners> without_shared_faces(const std::vector<Corners>& triangles, double skin) const;
  /// The largest distance from the surface of any point of the triangles. Triangles that may contain a larger distance
  /// are halved. `unmeasured` is the possible excess of distances above the floor, including what some millions of
  /// halvings leave open.
  Deviation largest(const std::vector<Corners>& triangles, const DistanceSearch& search) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace nilas::mesh
