#pragma once
/// Makes a closed, outward, manifold triangle mesh without self-intersections from the export of a drawing program.
#include <string>

#include "core/geometry/mesh.h"
#include "core/mesh/mend/polygon_soup.h"

namespace nilas::mesh {

/// One kind of fault with its places: mended, or not mendable.
struct MeshNote {
  std::string what;
  std::size_t count = 0;
  std::vector<Vec3> places;  ///< places of the fault, at most `k_most_places` [m]
  static constexpr std::size_t k_most_places = 200;
};

/// Limits of mending, as lengths in the given mesh.
struct MendSettings {
  double gap = 0;           ///< points this close are one, and cracks this wide are closed [m]
  double largest_hole = 0;  ///< holes up to this distance across are filled [m]
};

/// The result of mending, with an account of the faults.
struct MendedMesh {
  geometry::TriangleMesh mesh;  ///< mended mesh; sound if `open` is empty
  std::vector<MeshNote> done;   ///< mended faults, in the order of mending
  std::vector<MeshNote> open;   ///< remaining faults
};

/// Welds, drops faces that are double or without area, winds all faces alike and outward, closes T-junctions, cracks
/// and holes, unites overlapping shells, drops shells inside others, cuts self-intersections away. Coordinates in
/// metres, none beyond 1e6. Throws InputError where nothing with a volume is left, where a face has more than 10000
/// corners, or where CGAL fails. Throws ContractError unless the gap is positive.
MendedMesh mend(const PolygonSoup& soup, const MendSettings& settings);

}  // namespace nilas::mesh
