#pragma once
/// Closed triangle meshes: hulls and mesh-shaped bodies.
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/math.h"

namespace nilas::geometry {

/// Indexed triangle mesh; triangles wind counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<Vec3> vertices;                 ///< [m]
  std::vector<std::array<int, 3>> triangles;  ///< indices into vertices
};

/// The defects of a mesh as a solid; none when it is closed, manifold and outward. Triangles that repeat a vertex have
/// no edges of their own and count as degenerate only. A mesh without triangles is open.
struct MeshDefects {
  int open_edges = 0;            ///< edges used by one triangle only
  int non_manifold_edges = 0;    ///< edges used by more than two triangles, or twice in the same direction
  int degenerate_triangles = 0;  ///< zero area (height below 1e-14 of the longest edge) or repeated vertices
  bool inward = false;           ///< signed volume not positive
  Vec3 example = Vec3::Zero();   ///< a point on the first defect [m]
  bool closed() const { return open_edges == 0 && non_manifold_edges == 0; }
  bool sound() const { return closed() && degenerate_triangles == 0 && !inward; }
  std::string text() const;  ///< one sentence naming counts and the example place
};
/// Throws ContractError when a triangle names a vertex that is not there.
MeshDefects find_defects(const TriangleMesh& mesh);

/// Reads binary or ASCII STL and welds bit-equal vertices; the winding counts, normals in the file do not. Throws
/// FileError (cannot open) or InputError (content wrong or cut short, not finite, no triangles).
TriangleMesh read_stl(const std::filesystem::path& file);
/// Writes binary STL (float32 coordinates). Throws FileError, or InputError for a coordinate beyond float32.
void write_stl(const TriangleMesh& mesh, const std::filesystem::path& file);

/// The mesh rounded to float32 coordinates, as a binary STL stores it.
TriangleMesh rounded_to_float(TriangleMesh mesh);

/// Volume inside a closed mesh, negative when it is wound inwards [m^3].
double signed_volume(const TriangleMesh& mesh);

}  // namespace nilas::geometry
