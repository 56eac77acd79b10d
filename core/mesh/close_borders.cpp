/// Cracks, T-junctions and holes.
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/internal/Snapping/snap.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/property_map.h>
#include <fmt/format.h>

#include "core/mesh/surface_mesh.h"

namespace nilas {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Halfedge = SurfaceMesh::Halfedge_index;

std::vector<Vec3> border_places(const SurfaceMesh& mesh) {
  std::vector<Vec3> places;
  for (const auto h : mesh.halfedges())
    if (mesh.is_border(h))
      places.push_back(0.5 * (to_vec(mesh.point(mesh.source(h))) + to_vec(mesh.point(mesh.target(h)))));
  return places;
}

/// Shells one by one first: where two of them share an edge, four borders meet there.
std::size_t stitch(SurfaceMesh& mesh) {
  return PMP::stitch_borders(mesh, CGAL::parameters::apply_per_connected_component(true)) + PMP::stitch_borders(mesh);
}

/// A corner on a neighbour's edge cuts that edge, and so the neighbour. What then meets may still be wound differently.
void join_borders(SurfaceMesh& mesh, double gap, std::vector<MeshNote>& done) {
  if (CGAL::is_closed(mesh)) return;
  stitch(mesh);
  const auto before = border_places(mesh);
  if (before.empty()) return;
  const auto tolerance = CGAL::Constant_property_map<SurfaceMesh::Vertex_index, double>(gap);
  PMP::experimental::snap_borders(mesh, tolerance);
  mesh.collect_garbage();
  const TriangleMesh loose = triangles_of(mesh);
  PolygonSoup soup{loose.vertices, {}};
  for (const auto& t : loose.triangles) soup.polygons.push_back({t[0], t[1], t[2]});
  std::vector<MeshNote> again;
  mesh = mesh_of_soup(soup, gap, false, again);
  stitch(mesh);
  for (const auto& note : again)
    if (note.what.find("turned") != std::string::npos) done.push_back(note);
  const std::size_t left = border_places(mesh).size();
  if (left < before.size())
    add_note(done, "open edges closed where a corner lies on a neighbour's edge or across a crack",
             before.size() - left, before);
}

struct Hole {
  Halfedge start;
  std::size_t edges = 0;
  double across = 0;  ///< diagonal of its bounding box [m]
  Vec3 centre = Vec3::Zero();
};

Hole measured(const SurfaceMesh& mesh, Halfedge start) {
  Hole hole{start, 0, 0, Vec3::Zero()};
  Vec3 low = to_vec(mesh.point(mesh.target(start))), high = low;
  for (const auto h : mesh.halfedges_around_face(start)) {
    const Vec3 p = to_vec(mesh.point(mesh.target(h)));
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    ++hole.edges;
  }
  hole.across = (high - low).norm();
  hole.centre = 0.5 * (low + high);
  return hole;
}

std::vector<Hole> holes(const SurfaceMesh& mesh) {
  std::vector<Halfedge> starts;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(starts));
  std::vector<Hole> found;
  for (const auto h : starts) found.push_back(measured(mesh, h));
  return found;
}

bool fill(SurfaceMesh& mesh, const Hole& hole) {
  constexpr std::size_t k_cubic = 400;  // edges up to which the search over all triangulations takes seconds at most
  std::vector<SurfaceMesh::Face_index> faces;
  PMP::triangulate_hole(mesh, hole.start, std::back_inserter(faces),
                        CGAL::parameters::do_not_use_cubic_algorithm(hole.edges > k_cubic));
  return !faces.empty();
}

void fill_holes(SurfaceMesh& mesh, double largest, MendedMesh& notes) {
  std::vector<Vec3> filled, left;
  double widest = 0;
  for (const auto& hole : holes(mesh)) {
    const bool small = hole.across <= largest && fill(mesh, hole);
    (small ? filled : left).push_back(hole.centre);
    if (!small) widest = std::max(widest, hole.across);
  }
  add_note(notes.done, "holes filled", filled.size(), filled);
  add_note(notes.open,
           fmt::format("holes left open (the widest {:.4g} m across; --fill-holes allows {:.4g} m)", widest, largest),
           left.size(), left);
}

void remove_flat_faces(SurfaceMesh& mesh, std::vector<MeshNote>& done) {
  std::vector<SurfaceMesh::Face_index> flat;
  PMP::degenerate_faces(mesh, std::back_inserter(flat));
  if (flat.empty()) return;
  std::vector<Vec3> places;
  for (const auto f : flat) places.push_back(middle(mesh, f));
  PMP::remove_degenerate_faces(mesh);
  mesh.collect_garbage();
  add_note(done, "faces without area merged into their neighbours", flat.size(), places);
}

}  // namespace

void close_borders(SurfaceMesh& mesh, const MendSettings& settings, MendedMesh& notes) {
  join_borders(mesh, settings.gap, notes.done);
  remove_flat_faces(mesh, notes.done);
  if (!CGAL::is_closed(mesh)) fill_holes(mesh, settings.largest_hole, notes);
  mesh.collect_garbage();
}

}  // namespace nilas
