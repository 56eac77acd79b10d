/// Cracks, T-junctions and holes.
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/internal/Snapping/snap.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/property_map.h>
#include <fmt/format.h>

#include <set>

#include "core/mesh/mend/surface_mesh.h"

namespace nilas::mesh {

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

/// Whether every walk along halfedges ends.
bool well_linked(const SurfaceMesh& mesh) {
  const auto all = mesh.halfedges();
  return std::all_of(all.begin(), all.end(), [&](const Halfedge h) { return mesh.prev(mesh.next(h)) == h; });
}

/// Shells one by one first: where two of them share an edge, four borders meet there.
void stitch(SurfaceMesh& mesh) {
  NILAS_DEMAND(well_linked(mesh));
  for (const bool one_by_one : {true, false}) {
    SurfaceMesh tried = mesh;
    PMP::stitch_borders(tried, CGAL::parameters::apply_per_connected_component(one_by_one));
    // where a border meets itself CGAL may leave walks that never return
    if (well_linked(tried)) mesh = std::move(tried);
  }
}

/// A corner on a neighbour's edge cuts that edge, and so the neighbour. What then meets may still be wound differently.
void join_borders(WeldedSoup& welded, double gap, MendedMesh& notes) {
  SurfaceMesh& mesh = welded.mesh;
  if (CGAL::is_closed(mesh)) return;
  stitch(mesh);
  const auto before = border_places(mesh);
  if (before.empty()) return;
  const auto tolerance = CGAL::Constant_property_map<SurfaceMesh::Vertex_index, double>(gap);
  PMP::experimental::snap_borders(mesh, tolerance);
  mesh.collect_garbage();
  const geometry::TriangleMesh loose = triangles_of(mesh);
  PolygonSoup soup{loose.vertices, {}};
  for (const auto& t : loose.triangles) soup.polygons.push_back({t[0], t[1], t[2]});
  welded = mesh_of_soup(soup, gap, false, notes);
  stitch(mesh);
  const std::size_t left = border_places(mesh).size();
  if (left < before.size())
    add_note(notes.done, "open edges closed where a corner lies on a neighbour's edge or across a crack",
             before.size() - left, before);
}

using PlaceSet = std::set<std::array<double, 3>>;

PlaceSet set_of(const std::vector<Vec3>& places) {
  PlaceSet set;
  for (const auto& p : places) set.insert({p.x(), p.y(), p.z()});
  return set;
}

struct Hole {
  Halfedge start;
  std::size_t edges = 0;
  double across = 0;  ///< diagonal of its bounding box [m]
  Vec3 centre = Vec3::Zero();
  std::vector<Vec3> crowded;  ///< middles of those edges that more than two faces share
};

Hole measured(const SurfaceMesh& mesh, Halfedge start, const PlaceSet& crowded) {
  Hole hole{start, 0, 0, Vec3::Zero(), {}};
  Vec3 low = to_vec(mesh.point(mesh.target(start))), high = low;
  for (const auto h : mesh.halfedges_around_face(start)) {
    const Vec3 p = to_vec(mesh.point(mesh.target(h))), m = 0.5 * (p + to_vec(mesh.point(mesh.source(h))));
    if (crowded.contains({m.x(), m.y(), m.z()})) hole.crowded.push_back(m);
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    ++hole.edges;
  }
  hole.across = (high - low).norm();
  hole.centre = 0.5 * (low + high);
  return hole;
}

std::vector<Hole> holes(const SurfaceMesh& mesh, const PlaceSet& crowded) {
  std::vector<Halfedge> starts;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(starts));
  std::vector<Hole> found;
  for (const auto h : starts) found.push_back(measured(mesh, h, crowded));
  return found;
}

bool fill(SurfaceMesh& mesh, const Hole& hole) {
  constexpr std::size_t k_cubic = 400;  // edges up to which the search over all triangulations takes seconds at most
  std::vector<SurfaceMesh::Face_index> faces;
  PMP::triangulate_hole(mesh, hole.start, std::back_inserter(faces),
                        CGAL::parameters::do_not_use_cubic_algorithm(hole.edges > k_cubic));
  return !faces.empty();
}

void fill_holes(WeldedSoup& welded, double largest, MendedMesh& notes) {
  std::vector<Vec3> filled, left;
  PlaceSet walls;  // each of their edges bounds several holes
  double widest = 0;
  for (const auto& hole : holes(welded.mesh, set_of(welded.crowded))) {
    if (hole.across <= largest && fill(welded.mesh, hole)) {
      filled.push_back(hole.centre);
    } else if (!hole.crowded.empty()) {
      walls.merge(set_of(hole.crowded));
    } else {
      left.push_back(hole.centre);
      widest = std::max(widest, hole.across);
    }
  }
  std::vector<Vec3> shared;
  for (const auto& p : walls) shared.emplace_back(p[0], p[1], p[2]);
  add_note(notes.open, "edges that more than two faces share (an inner wall or deck: leave it out, or close it)",
           shared.size(), shared);
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

void close_borders(WeldedSoup& welded, const MendSettings& settings, MendedMesh& notes) {
  join_borders(welded, settings.gap, notes);
  remove_flat_faces(welded.mesh, notes.done);
  if (!CGAL::is_closed(welded.mesh)) fill_holes(welded, settings.largest_hole, notes);
  welded.mesh.collect_garbage();
}

}  // namespace nilas::mesh
