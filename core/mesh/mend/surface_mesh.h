#pragma once
/// CGAL's mesh type for this folder. Includes CGAL, so include it in this folder's sources only.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "core/base/error.h"
#include "core/mesh/mend/mend.h"

namespace nilas::mesh {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// The message where mending leaves nothing.
inline constexpr const char* k_nothing_left = "nothing that encloses a volume is left";

inline Kernel::Point_3 to_point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
inline Vec3 to_vec(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

/// Turns off what CGAL prints beside the exceptions it throws.
void silence_cgal();

/// Returns the result of `work`. Any exception of CGAL, or ours about CGAL's result, becomes an InputError with the
/// text `failed`, because the mesh is the cause. An InputError and a lack of memory pass unchanged.
template <class Work>
auto by_cgal(const char* failed, const Work& work) {
  silence_cgal();
  try {
    return work();
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    throw InputError(failed);
  }
}

/// Vertices and triangles in the order of the mesh's indices.
geometry::TriangleMesh triangles_of(const SurfaceMesh& mesh);
/// Vertices whose triangles are more than one fan: there the surface of a closed mesh touches itself.
std::vector<Vec3> pinched_vertices(const geometry::TriangleMesh& mesh);
/// Throws ContractError where the triangles do not make a manifold; a vertex may not be pinched.
SurfaceMesh surface_of(const geometry::TriangleMesh& mesh);
/// Middle of a face's corners [m].
Vec3 middle(const SurfaceMesh& mesh, SurfaceMesh::Face_index face);

/// Whether faces meet elsewhere than at shared corners and edges.
bool crosses_itself(const SurfaceMesh& mesh);
/// Places midway between the centres of such faces, one per pair [m].
std::vector<Vec3> crossings(const SurfaceMesh& mesh);

/// Adds to the note with this text, which several rounds may find, or starts it; does nothing where the count is 0.
void add_note(std::vector<MeshNote>& notes, std::string what, std::size_t count, const std::vector<Vec3>& places);

/// A mesh made of loose polygons.
struct WeldedSoup {
  SurfaceMesh mesh;
  std::vector<Vec3> crowded;  ///< middles of edges that more than two faces share; the mesh is torn open there [m]
};

/// The steps of mend(), each with notes on what it did.
/// Welds within the gap, drops faces without area and double ones, winds alike, makes triangles. Two faces back to
/// back are a fold, and go both, unless `backs_are_copies`. Throws InputError where no face with an area is left.
WeldedSoup mesh_of_soup(const PolygonSoup& soup, double gap, bool backs_are_copies, MendedMesh& notes);
/// Joins borders: cracks, T-junctions, holes up to the size given; holes and crowded edges that stay go to `open`.
void close_borders(WeldedSoup& welded, const MendSettings& settings, MendedMesh& notes);
/// Splits into shells, mends each, unites them; crossings that stay go to `open`. The mesh must be closed.
void resolve_shells(SurfaceMesh& mesh, MendedMesh& notes);

}  // namespace nilas::mesh
