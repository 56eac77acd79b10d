/// Makes a mesh from loose polygons: consistent winding, triangles only.
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <map>

#include "core/base/error.h"
#include "core/base/union_find.h"
#include "core/mesh/mend/surface_mesh.h"

namespace nilas::mesh {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Points = std::vector<Kernel::Point_3>;
using Polygons = std::vector<std::vector<std::size_t>>;

/// The representative of each point: the first representative within `gap` of it.
std::vector<std::size_t> stand_ins(const std::vector<Vec3>& points, double gap) {
  using Cell = std::array<long long, 3>;
  std::map<Cell, std::vector<std::size_t>> cells;
  const auto cell_of = [&](const Vec3& p) {
    Cell c{};
    for (std::size_t k = 0; k < 3; ++k) c[k] = std::llround(std::floor(p[static_cast<Eigen::Index>(k)] / gap));
    return c;
  };
  constexpr int k_neighbours = 27;
  std::vector<std::size_t> found(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Cell home = cell_of(points[i]);
    found[i] = i;
    for (int n = 0; n < k_neighbours; ++n) {
      const auto cell = cells.find({home[0] + n % 3 - 1, home[1] + n / 3 % 3 - 1, home[2] + n / 9 - 1});
      if (cell == cells.end()) continue;
      for (const std::size_t j : cell->second)
        if (j < found[i] && (points[i] - points[j]).norm() <= gap) found[i] = j;
    }
    if (found[i] == i) cells[home].push_back(i);
  }
  return found;
}

std::vector<Vec3> places_of(const Points& points, const Polygons& polygons, const std::vector<bool>& which) {
  std::vector<Vec3> places;
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    if (!which[f]) continue;
    Vec3 sum = Vec3::Zero();
    for (const std::size_t v : polygons[f]) sum += to_vec(points[v]);
    places.emplace_back(sum / static_cast<double>(polygons[f].size()));
  }
  return places;
}

/// Replaces each corner of the loops by its representative.
void rename(Polygons& polygons, const std::vector<std::size_t>& stand_in) {
  for (auto& loop : polygons)
    for (auto& v : loop) v = stand_in[v];
}

/// Joins points within the gap.
void weld(const std::vector<Vec3>& points, double gap, Polygons& polygons, std::vector<MeshNote>& done) {
  const auto stand_in = stand_ins(points, gap);
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < stand_in.size(); ++i)
    if (points[i] != points[stand_in[i]]) places.push_back(points[i]);
  add_note(done, "points joined to one that is closer than the gap", places.size(), places);
  rename(polygons, stand_in);
}

/// The representative of each point: the first one that is equal to it.
std::vector<std::size_t> equal_points(const std::vector<Vec3>& points) {
  std::map<std::array<double, 3>, std::size_t> seen;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < points.size(); ++i)
    found.push_back(seen.try_emplace({points[i].x(), points[i].y(), points[i].z()}, i).first->second);
  return found;
}

/// The loops between visits to the same corner that have an area; `on_way` is all false before and after.
Polygons simple_loops(const std::vector<std::size_t>& loop, std::vector<bool>& on_way) {
  Polygons simple;
  std::vector<std::size_t> way;
  const auto cut_off = [&](std::size_t start) {
    if (way.size() - start >= 3) simple.emplace_back(way.begin() + static_cast<std::ptrdiff_t>(start), way.end());
    for (std::size_t k = start; k < way.size(); ++k) on_way[way[k]] = false;
    way.resize(start);
  };
  for (const std::size_t v : loop) {
    if (on_way[v]) {
      std::size_t start = way.size() - 1;
      while (way[start] != v) --start;
      cut_off(start);
    }
    way.push_back(v);
    on_way[v] = true;
  }
  cut_off(0);
  return simple;
}

/// Loops that visit no corner twice; CGAL's stitching does not end on others.
void make_simple(const Points& points, Polygons& polygons, std::vector<MeshNote>& done) {
  std::vector<bool> on_way(points.size(), false), collapsed, split;
  Polygons kept;
  for (const auto& loop : polygons) {
    Polygons simple = simple_loops(loop, on_way);
    collapsed.push_back(simple.empty());
    split.push_back(simple.size() > 1);
    for (auto& part : simple) kept.push_back(std::move(part));
  }
  auto places = places_of(points, polygons, collapsed);
  add_note(done, "faces without area dropped", places.size(), places);
  places = places_of(points, polygons, split);
  add_note(done, "faces that visit a corner more than once split there", places.size(), places);
  polygons = std::move(kept);
}

/// Loops over the same corners, as often as they are there.
std::map<std::vector<std::size_t>, std::vector<std::size_t>> by_corners(const Polygons& polygons) {
  std::map<std::vector<std::size_t>, std::vector<std::size_t>> same;
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    auto key = polygons[f];
    std::sort(key.begin(), key.end());
    same[key].push_back(f);
  }
  return same;
}

void erase(const Points& points, Polygons& polygons, const std::vector<bool>& which, const char* what,
           std::vector<MeshNote>& done) {
  const auto places = places_of(points, polygons, which);
  add_note(done, what, places.size(), places);
  std::size_t f = 0;
  std::erase_if(polygons, [&](const auto&) { return static_cast<bool>(which[f++]); });
}

/// Copies with the same winding, or where `any_winding` with either: one stays.
void drop_copies(const Points& points, Polygons& polygons, bool any_winding, std::vector<MeshNote>& done) {
  std::vector<bool> again(polygons.size(), false);
  const auto alike = [&](std::size_t f, std::size_t g) {
    const auto &a = polygons[f], &b = polygons[g];
    const auto start = static_cast<std::size_t>(std::find(b.begin(), b.end(), a.front()) - b.begin());
    return any_winding || b[(start + 1) % b.size()] == a[1];
  };
  for (const auto& [corners, faces] : by_corners(polygons))
    for (auto face = faces.begin(); face != faces.end(); ++face)
      again[*face] = std::any_of(faces.begin(), face, [&, f = *face](std::size_t before) { return alike(f, before); });
  erase(points, polygons, again, "faces given more than once dropped", done);
}

/// Two faces back to back, a fin without thickness: none stays.
void drop_folds(const Points& points, Polygons& polygons, std::vector<MeshNote>& done) {
  std::vector<bool> folded(polygons.size(), false);
  for (const auto& [corners, faces] : by_corners(polygons))
    if (faces.size() > 1)
      for (std::size_t k = 0; k < faces.size() - faces.size() % 2; ++k) folded[faces[k]] = true;
  erase(points, polygons, folded, "faces of fins thinner than the gap dropped", done);
}

/// Winds neighbours alike; of each shell, what most of its faces had in the file.
void wind_alike(Points& points, Polygons& polygons, std::vector<MeshNote>& done) {
  std::vector<Kernel::Point_3> first;
  for (const auto& loop : polygons) first.push_back(points[loop.front()]);
  PMP::orient_polygon_soup(points, polygons);
  UnionFind shells(points.size());
  for (const auto& loop : polygons)
    for (const std::size_t v : loop) shells.join(loop.front(), v);
  std::map<std::size_t, long> balance;  // turned faces less those that stand as in the file, per shell
  std::vector<bool> turned;
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    turned.push_back(points[polygons[f].front()] != first[f]);
    balance[shells.find(polygons[f].front())] += turned.back() ? 1 : -1;
  }
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    if (balance[shells.find(polygons[f].front())] <= 0) continue;
    std::reverse(polygons[f].begin(), polygons[f].end());
    turned[f] = !turned[f];
  }
  const auto places = places_of(points, polygons, turned);
  add_note(done, "faces turned to the winding of their neighbours", places.size(), places);
}

/// Middles of the edges that more than two polygons share.
std::vector<Vec3> crowded_edges(const Points& points, const Polygons& polygons) {
  std::map<std::pair<std::size_t, std::size_t>, int> uses;
  for (const auto& loop : polygons)
    for (std::size_t k = 0; k < loop.size(); ++k) ++uses[std::minmax(loop[k], loop[(k + 1) % loop.size()])];
  std::vector<Vec3> crowded;
  for (const auto& [edge, count] : uses)
    if (count > 2) crowded.emplace_back(0.5 * (to_vec(points[edge.first]) + to_vec(points[edge.second])));
  return crowded;
}

bool can_be_cut_alone(const SurfaceMesh& mesh, SurfaceMesh::Face_index face) {
  SurfaceMesh alone;
  std::vector<SurfaceMesh::Vertex_index> corners;
  for (const auto v : mesh.vertices_around_face(mesh.halfedge(face)))
    corners.push_back(alone.add_vertex(mesh.point(v)));
  alone.add_face(corners);
  return PMP::triangulate_faces(alone);
}

/// Cuts faces into triangles; those that cannot be cut go, with a note of what is open.
void make_triangles(SurfaceMesh& mesh, std::vector<MeshNote>& open) {
  SurfaceMesh cut = mesh;  // a face that could not be cut is left with links that lead nowhere
  if (PMP::triangulate_faces(cut)) {
    mesh = std::move(cut);
    return;
  }
  std::vector<Vec3> places;
  for (const auto f : mesh.faces()) {
    if (can_be_cut_alone(mesh, f)) continue;
    places.push_back(middle(mesh, f));
    CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  }
  mesh.collect_garbage();
  NILAS_DEMAND(PMP::triangulate_faces(mesh));
  add_note(open, "faces that cross themselves could not be cut into triangles", places.size(), places);
}

}  // namespace

WeldedSoup mesh_of_soup(const PolygonSoup& soup, double gap, bool backs_are_copies, MendedMesh& notes) {
  auto& done = notes.done;
  Points points;
  Polygons polygons;
  for (const auto& p : soup.points) points.push_back(to_point(p));
  for (const auto& loop : soup.polygons) polygons.emplace_back(loop.begin(), loop.end());
  rename(polygons, equal_points(soup.points));
  make_simple(points, polygons, done);
  drop_copies(points, polygons, backs_are_copies, done);
  weld(soup.points, gap, polygons, done);
  make_simple(points, polygons, done);
  drop_folds(points, polygons, done);
  PMP::repair_polygon_soup(points, polygons);
  if (polygons.empty()) throw InputError(k_nothing_left);
  WeldedSoup welded{{}, crowded_edges(points, polygons)};
  wind_alike(points, polygons, done);
  NILAS_DEMAND(PMP::is_polygon_soup_a_polygon_mesh(polygons));
  PMP::polygon_soup_to_polygon_mesh(points, polygons, welded.mesh);
  make_triangles(welded.mesh, notes.open);
  return welded;
}

}  // namespace nilas::mesh
