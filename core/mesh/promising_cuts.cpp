#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <map>

#include "core/mesh/pieces.h"

namespace nilas {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

/// A hollow edge and how much it bends [m rad].
struct HollowEdge {
  SurfaceMesh::Halfedge_index edge;
  double weight;
};

std::vector<HollowEdge> hollow_edges(const SurfaceMesh& piece) {
  constexpr double k_sharp = 0.05;  // [rad]: less is a curve in facets
  std::vector<HollowEdge> found;
  for (const auto e : piece.edges()) {
    const auto h = piece.halfedge(e), o = piece.opposite(h);
    const auto n = PMP::compute_face_normal(piece.face(h), piece), m = PMP::compute_face_normal(piece.face(o), piece);
    const auto& a = piece.point(piece.target(h));
    if (n * (piece.point(piece.target(piece.next(o))) - a) <= 0) continue;
    const double angle = std::acos(std::clamp(n * m, -1.0, 1.0));
    const double length = std::sqrt(CGAL::squared_distance(piece.point(piece.source(h)), a));
    if (angle > k_sharp) found.push_back({h, angle * length});
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.weight > b.weight; });
  return found;
}

Plane across(int axis, double place) {
  return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0, -place};
}

void add_even(const SurfaceMesh& piece, std::vector<Plane>& planes) {
  constexpr int k_slices = 12;
  const auto box = PMP::bbox(piece);
  for (int axis = 0; axis < 3; ++axis)
    for (int k = 1; k < k_slices; ++k)
      planes.push_back(across(axis, box.min(axis) + (box.max(axis) - box.min(axis)) * k / k_slices));
}

/// Axis planes through the ends of hollow edges, those that bear most; and the planes of the sharpest edges' faces.
void add_hollow(const SurfaceMesh& piece, std::vector<Plane>& planes) {
  const auto edges = hollow_edges(piece);
  constexpr std::size_t k_levels = 8, k_faces = 6;
  for (int axis = 0; axis < 3; ++axis) {
    std::map<double, double> weight;
    for (const auto& e : edges)
      for (const auto v : {piece.source(e.edge), piece.target(e.edge)}) weight[piece.point(v)[axis]] += e.weight;
    std::vector<std::pair<double, double>> levels;
    for (const auto& [place, w] : weight) levels.emplace_back(-w, place);
    std::sort(levels.begin(), levels.end());
    if (levels.size() > k_levels) levels.resize(k_levels);
    for (const auto& [w, place] : levels) planes.push_back(across(axis, place));
  }
  for (std::size_t k = 0; k < std::min(edges.size(), k_faces); ++k)
    for (const auto h : {edges[k].edge, piece.opposite(edges[k].edge)})
      planes.emplace_back(piece.point(piece.target(h)), PMP::compute_face_normal(piece.face(h), piece));
}

/// Points and edges that stand for a piece: all of a small one, every n-th edge of a large one.
std::vector<std::pair<Kernel::Point_3, Kernel::Point_3>> sample_edges(const SurfaceMesh& piece) {
  constexpr std::size_t k_most = 600;
  const std::size_t stride = 1 + piece.num_edges() / k_most;
  std::vector<std::pair<Kernel::Point_3, Kernel::Point_3>> edges;
  for (const auto e : piece.edges())
    if (edges.empty() || e.idx() % stride == 0)
      edges.emplace_back(piece.point(piece.vertex(e, 0)), piece.point(piece.vertex(e, 1)));
  return edges;
}

double hull_volume(const std::vector<Kernel::Point_3>& points) {
  const SurfaceMesh hull = convex_hull(points);
  return hull.is_empty() ? 0 : PMP::volume(hull);
}

/// Volume of both sides' convex hulls [m^3]; infinite where the plane leaves a side empty.
double volume_of_sides(const std::vector<std::pair<Kernel::Point_3, Kernel::Point_3>>& edges, const Plane& plane) {
  const auto height = [&](const Kernel::Point_3& p) {
    return plane.a() * p.x() + plane.b() * p.y() + plane.c() * p.z() + plane.d();
  };
  std::vector<Kernel::Point_3> low, high;
  for (const auto& [a, b] : edges) {
    const double ha = height(a), hb = height(b);
    (ha < 0 ? low : high).push_back(a);
    (hb < 0 ? low : high).push_back(b);
    if ((ha < 0) == (hb < 0)) continue;
    const auto crossing = a + (ha / (ha - hb)) * (b - a);
    low.push_back(crossing);
    high.push_back(crossing);
  }
  const double below = hull_volume(low), above = hull_volume(high);
  return below > 0 && above > 0 ? below + above : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<Plane> promising_cuts(const SurfaceMesh& piece, std::size_t most) {
  std::vector<Plane> planes;
  add_even(piece, planes);
  add_hollow(piece, planes);
  const auto edges = sample_edges(piece);
  std::vector<std::pair<double, std::size_t>> ranking;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const double volume = volume_of_sides(edges, planes[k]);
    if (std::isfinite(volume)) ranking.emplace_back(volume, k);
  }
  std::stable_sort(ranking.begin(), ranking.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Plane> best;
  for (std::size_t k = 0; k < std::min(most, ranking.size()); ++k) best.push_back(planes[ranking[k].second]);
  return best;
}

}  // namespace nilas
