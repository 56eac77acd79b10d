#pragma once
/// CGAL's mesh as this folder uses it. Includes CGAL, so stays within the folder's sources.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "core/mesh/mend.h"

namespace nilas {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

inline Kernel::Point_3 to_point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
inline Vec3 to_vec(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

/// Vertices and triangles in the order of the mesh's indices.
TriangleMesh triangles_of(const SurfaceMesh& mesh);
/// Throws ContractError where the triangles do not make a manifold.
SurfaceMesh surface_of(const TriangleMesh& mesh);
/// Middle of a face's corners [m].
Vec3 middle(const SurfaceMesh& mesh, SurfaceMesh::Face_index face);

/// Faces that meet elsewhere than at shared corners and edges.
bool crosses_itself(const SurfaceMesh& mesh);

/// Adds to `notes` unless the count is 0.
void add_note(std::vector<MeshNote>& notes, std::string what, std::size_t count, std::vector<Vec3> places);

/// The steps of mend(), each with notes on what it did.
/// Welds within the gap, drops faces without area and double ones, winds alike, makes triangles. Two faces back to
/// back are a fold, and go both, unless `backs_are_copies`.
SurfaceMesh mesh_of_soup(const PolygonSoup& soup, double gap, bool backs_are_copies, std::vector<MeshNote>& done);
/// Joins borders: cracks, T-junctions, holes up to the size given; holes that stay go to `open`.
void close_borders(SurfaceMesh& mesh, const MendSettings& settings, MendedMesh& notes);
/// Splits into shells, mends each, unites them; crossings that stay go to `open`. The mesh must be closed.
void resolve_shells(SurfaceMesh& mesh, MendedMesh& notes);

}  // namespace nilas
