#pragma once
/// Decomposition of a closed mesh into convex pieces, for contact.
#include "core/geometry/mesh.h"

namespace nilas::mesh {

/// Requirements for the convex pieces.
struct PartSettings {
  double tolerance = 0;    ///< largest permitted deviation [m]
  std::size_t most = 64;   ///< largest number of pieces
  bool symmetric = false;  ///< about y = 0; each piece is then its own image or one of a pair
  int threads = 1;         ///< number of threads; the pieces do not depend on it
};

/// Distance between the surface of the pieces' union and the mesh.
struct Deviation {
  double largest = 0;         ///< largest distance of the measured points, in both directions [m]
  double unmeasured = 0;      ///< no point deviates by more than `largest` plus this [m]
  Vec3 place = Vec3::Zero();  ///< place of the largest deviation [m]
};

/// The deviation of a number of pieces.
struct PartCount {
  std::size_t parts = 0;
  double deviation = 0;  ///< largest deviation of their union from the mesh [m]
};

/// A mesh as convex pieces, and their deviation from it.
struct ConvexParts {
  std::vector<geometry::TriangleMesh> parts;  ///< convex pieces with coordinates as stored in binary STL
  Deviation deviation;
  std::vector<PartCount> table;  ///< upper bound, within a tenth, of the deviation of fewer pieces, and that of these
};

/// Cuts the mesh by planes, the worst piece first, until no piece's convex hull exceeds the mesh by more than the
/// tolerance, or there are four times as many pieces as allowed. Then joins neighbours whose common hull is also within
/// the tolerance. Where too many pieces remain, joins them beyond the tolerance too. The mesh must be closed, outward
/// and free of crossings. Throws InputError where CGAL cannot cut it, or where the pieces cannot be joined. Throws
/// ContractError unless tolerance and number are positive.
ConvexParts decompose(const geometry::TriangleMesh& mesh, const PartSettings& settings);

/// Distance in both directions between the surface of the union of convex pieces and a closed mesh, to within
/// `precision` [m]. Faces closer than 1e-6 of the size to the inside of another piece count as covered.
Deviation deviation_of(const std::vector<geometry::TriangleMesh>& parts, const geometry::TriangleMesh& mesh,
                       double precision);

/// A mesh is symmetric where asymmetry() is at most this share of its longest side: drawings round their coordinates.
inline constexpr double k_symmetric_share = 1e-5;

/// Largest distance of the mesh from its mirror image in y = 0, within 2 % and three millionths of its size [m].
double asymmetry(const geometry::TriangleMesh& mesh);

}  // namespace nilas::mesh
