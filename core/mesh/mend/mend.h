#pragma once
/// Makes a closed, outward, manifold triangle mesh free of self-intersections of what a drawing program exported.
#include <string>

#include "core/geometry/mesh.h"
#include "core/mesh/mend/polygon_soup.h"

namespace nilas {

/// One kind of fault with its places: mended, or beyond mending.
struct MeshNote {
  std::string what;
  std::size_t count = 0;
  std::vector<Vec3> places;  ///< at most `k_most_places` of them [m]
  static constexpr std::size_t k_most_places = 200;
};

/// How much of what is wrong may be mended; both are lengths of the mesh given.
struct MendSettings {
  double gap = 0;           ///< points this close are one, and cracks this wide are closed [m]
  double largest_hole = 0;  ///< holes up to this distance across are filled [m]
};

/// What mending made of a mesh, and its account of it.
struct MendedMesh {
  TriangleMesh mesh;           ///< as good as it got; sound where `open` is empty
  std::vector<MeshNote> done;  ///< what was mended, in this order
  std::vector<MeshNote> open;  ///< what is left
};

/// Welds, drops faces that are double or without area, winds all faces alike and outward, closes T-junctions, cracks
/// and holes, unites overlapping shells, drops shells inside others, cuts self-intersections away. Coordinates in
/// metres, none beyond 1e6. Throws InputError where nothing with a volume is left.
MendedMesh mend(const PolygonSoup& soup, const MendSettings& settings);

}  // namespace nilas
