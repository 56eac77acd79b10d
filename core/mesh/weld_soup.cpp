/// From loose polygons to a mesh: one winding, triangles only.
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <map>
#include <numeric>

#include "core/base/error.h"
#include "core/mesh/surface_mesh.h"

namespace nilas {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Points = std::vector<Kernel::Point_3>;
using Polygons = std::vector<std::vector<std::size_t>>;

/// For each point the first one that lies within `gap` of it, sought among those that stand for themselves.
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

/// The loops with each corner's stand-in.
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

/// Joins points that are equal to the bit.
std::vector<std::size_t> equal_points(const std::vector<Vec3>& points) {
  std::map<std::array<double, 3>, std::size_t> seen;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < points.size(); ++i)
    found.push_back(seen.try_emplace({points[i].x(), points[i].y(), points[i].z()}, i).first->second);
  return found;
}

/// A loop without repeated neighbours; fewer than three corners are left of a polygon without area.
void drop_collapsed(const Points& points, Polygons& polygons, std::vector<MeshNote>& done) {
  std::vector<bool> collapsed;
  for (auto& loop : polygons) {
    auto distinct = loop;
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    while (distinct.size() > 1 && distinct.front() == distinct.back()) distinct.pop_back();
    collapsed.push_back(distinct.size() < 3);
    if (!collapsed.back()) loop = std::move(distinct);
  }
  const auto places = places_of(points, polygons, collapsed);
  add_note(done, "faces without area dropped", places.size(), places);
  Polygons kept;
  for (std::size_t f = 0; f < polygons.size(); ++f)
    if (!collapsed[f]) kept.push_back(std::move(polygons[f]));
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
    for (std::size_t k = 1; k < faces.size(); ++k)
      again[faces[k]] = std::any_of(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(k),
                                    [&](std::size_t before) { return alike(faces[k], before); });
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
  std::vector<std::size_t> root(points.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (const auto& loop : polygons)
    for (const std::size_t v : loop) root[find(v)] = find(loop.front());
  std::map<std::size_t, long> balance;  // turned faces less those that stand as in the file, per shell
  std::vector<bool> turned;
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    turned.push_back(points[polygons[f].front()] != first[f]);
    balance[find(polygons[f].front())] += turned.back() ? 1 : -1;
  }
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    if (balance[find(polygons[f].front())] <= 0) continue;
    std::reverse(polygons[f].begin(), polygons[f].end());
    turned[f] = !turned[f];
  }
  const auto places = places_of(points, polygons, turned);
  add_note(done, "faces turned to the winding of their neighbours", places.size(), places);
}

}  // namespace

SurfaceMesh mesh_of_soup(const PolygonSoup& soup, double gap, bool backs_are_copies, std::vector<MeshNote>& done) {
  Points points;
  Polygons polygons;
  for (const auto& p : soup.points) points.push_back(to_point(p));
  for (const auto& loop : soup.polygons) polygons.emplace_back(loop.begin(), loop.end());
  rename(polygons, equal_points(soup.points));
  drop_copies(points, polygons, backs_are_copies, done);
  weld(soup.points, gap, polygons, done);
  drop_collapsed(points, polygons, done);
  drop_folds(points, polygons, done);
  PMP::repair_polygon_soup(points, polygons);
  if (polygons.empty()) throw InputError("no face with an area is left");
  wind_alike(points, polygons, done);
  SurfaceMesh mesh;
  if (!PMP::is_polygon_soup_a_polygon_mesh(polygons)) throw InputError("the faces do not make a surface");
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  if (!PMP::triangulate_faces(mesh)) throw InputError("a face with many corners could not be cut into triangles");
  return mesh;
}

}  // namespace nilas
