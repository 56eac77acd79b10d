#pragma once
/// Convex parts of a closed mesh, for contact.
#include "core/geometry/mesh.h"

namespace nilas {

/// What is asked of convex parts.
struct PartSettings {
  double tolerance = 0;    ///< worst deviation wanted [m]
  std::size_t most = 64;   ///< parts, at most
  bool symmetric = false;  ///< about y = 0: then so are the parts, each its own image or one of a pair
  int threads = 1;         ///< the parts do not depend on it
};

/// How far the surface of the parts' union and the mesh stand from each other.
struct Deviation {
  double largest = 0;         ///< of the points that were measured, both ways [m]
  double unmeasured = 0;      ///< no point stands further off than `largest` plus this [m]
  Vec3 place = Vec3::Zero();  ///< of the largest [m]
};

/// What so many parts leave.
struct PartCount {
  std::size_t parts = 0;
  double deviation = 0;  ///< largest of their union from the mesh [m]
};

/// A mesh as convex parts, and how well they stand for it.
struct ConvexParts {
  std::vector<TriangleMesh> parts;  ///< each convex, its coordinates as binary STL stores them
  Deviation deviation;
  std::vector<PartCount> table;  ///< what fewer parts would leave at most, within a tenth, and what these do
};

/// Cuts the mesh by planes, the worst piece first, until no piece's convex hull stands further outside the mesh than
/// the tolerance or there are as many parts as allowed; then joins neighbours whose common hull is within the tolerance
/// too. The mesh must be closed, outward, free of crossings. Throws InputError where CGAL cannot cut it.
ConvexParts decompose(const TriangleMesh& mesh, const PartSettings& settings);

/// Both ways between the surface of the union of convex parts and a closed mesh, to within `precision` [m]. Faces of
/// parts closer than 1e-6 of the size to another part's inside count as covered.
Deviation deviation_of(const std::vector<TriangleMesh>& parts, const TriangleMesh& mesh, double precision);

/// A mesh is symmetric where asymmetry() is at most this share of its longest side: drawings round their coordinates.
inline constexpr double k_symmetric_share = 1e-5;

/// Largest distance from the mesh of its image in y = 0, within 2 % and three millionths of its size [m].
double asymmetry(const TriangleMesh& mesh);

}  // namespace nilas
