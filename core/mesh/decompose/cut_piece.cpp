/// Cuts a closed mesh by a plane. CGAL's clip() is not used: it computes each side's intersection with a box in exact
/// arithmetic, fails on faces that are narrow or lie in the plane, and takes a hundred times as long.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <map>

#include "core/base/union_find.h"
#include "core/geometry/mesh_box.h"
#include "core/mesh/decompose/pieces.h"
#include "core/mesh/mend/surface_mesh.h"

namespace nilas::mesh {

namespace {

/// Vertex of the mesh that a point of the triangulation stands for.
struct Corner {
  int number = -1;
};
/// Whether a face lies within the rim: -1 not known, 0 outside, 1 inside.
struct Place {
  int inside = -1;
};
using CapVertex = CGAL::Triangulation_vertex_base_with_info_2<Corner, Kernel>;
using CapFace =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<Place, Kernel>>;
// rounded rims may cross themselves in a sliver
using CapTriangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<CapVertex, CapFace>,
                                               CGAL::Exact_predicates_tag>;

/// Heights of all vertices above the plane; 0 where float32 rounding may have moved a vertex off it.
std::vector<double> heights_over(const HalfSpace& plane, const geometry::TriangleMesh& piece) {
  constexpr double k_rounding = 1e-7;  // share of a coordinate
  const auto box = geometry::box_of(piece);
  const double skin = k_rounding * std::max(box.max().cwiseAbs().maxCoeff(), box.min().cwiseAbs().maxCoeff());
  std::vector<double> heights;
  for (const auto& p : piece.vertices) {
    const double height = plane.height(p);
    heights.push_back(std::abs(height) <= skin ? 0 : height);
  }
  return heights;
}

/// The part of the surface below the plane, open along it and without faces in it. Vertices of the piece keep their
/// numbers.
geometry::TriangleMesh surface_below(const geometry::TriangleMesh& piece, const HalfSpace& plane,
                                     const std::vector<double>& heights) {
  geometry::TriangleMesh side{piece.vertices, {}};
  const auto height = [&](int v) { return heights[v]; };
  std::map<std::pair<int, int>, int> crossings;
  const auto crossing = [&](int a, int b) {
    const int low = std::min(a, b), high = std::max(a, b);  // the neighbouring triangle must find the same point
    const auto [found, fresh] = crossings.try_emplace({low, high}, static_cast<int>(side.vertices.size()));
    if (fresh) {
      const Vec3 &p = side.vertices[low], &q = side.vertices[high];
      const Vec3 x = p + height(low) / (height(low) - height(high)) * (q - p);
      side.vertices.push_back(x - plane.height(x) * plane.normal);
    }
    return found->second;
  };
  for (const auto& t : piece.triangles) {
    if (std::none_of(t.begin(), t.end(), [&](int v) { return height(v) < 0; })) continue;
    std::vector<int> loop;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if (height(a) <= 0) loop.push_back(a);
      if ((height(a) < 0 && height(b) > 0) || (height(a) > 0 && height(b) < 0)) loop.push_back(crossing(a, b));
    }
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) side.triangles.push_back({loop[0], loop[k], loop[k + 1]});
  }
  return side;
}

/// Edges in the plane that only one triangle has.
std::vector<std::pair<int, int>> rim_of(const geometry::TriangleMesh& side, const std::vector<double>& heights) {
  const auto on_plane = [&](int v) {
    const auto k = static_cast<std::size_t>(v);
    return k >= heights.size() || heights[k] == 0;
  };
  std::map<std::pair<int, int>, int> uses;  // uses in one direction minus those in the other
  for (const auto& t : side.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (const int a = t[k], b = t[(k + 1) % 3]; on_plane(a) && on_plane(b))
        uses[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
  std::vector<std::pair<int, int>> rim;
  for (const auto& [edge, count] : uses)
    if (count % 2 != 0) rim.push_back(edge);
  return rim;
}

/// Marks faces as inside if an odd number of rims separates them from the outer face.
void mark_inside(CapTriangulation& cap) {
  std::vector<CapTriangulation::Face_handle> found{cap.infinite_face()};
  found.front()->info().inside = 0;
  while (!found.empty()) {
    const auto face = found.back();
    found.pop_back();
    for (int k = 0; k < 3; ++k) {
      const auto next = face->neighbor(k);
      if (next->info().inside >= 0) continue;
      next->info().inside = cap.is_constrained({face, k}) ? 1 - face->info().inside : face->info().inside;
      found.push_back(next);
    }
  }
}

/// Adds the cap in the plane that closes the side; it faces along the plane's normal.
void add_cap(geometry::TriangleMesh& side, const HalfSpace& plane, const std::vector<std::pair<int, int>>& rim) {
  const Vec3 across = plane.normal.unitOrthogonal(), up = plane.normal.cross(across);
  CapTriangulation cap;
  const auto insert = [&](int v) {
    const Vec3& p = side.vertices[v];
    const auto vertex = cap.insert({across.dot(p), up.dot(p)});
    if (vertex->info().number < 0) vertex->info().number = v;
    return vertex;
  };
  for (const auto& [a, b] : rim)
    if (const auto from = insert(a), to = insert(b); from != to) cap.insert_constraint(from, to);
  if (cap.dimension() < 2) return;
  mark_inside(cap);
  for (const auto face : cap.finite_face_handles()) {
    if (face->info().inside != 1) continue;
    std::array<int, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto vertex = face->vertex(static_cast<int>(k));
      if (vertex->info().number < 0) {  // where rims cross
        vertex->info().number = static_cast<int>(side.vertices.size());
        side.vertices.push_back(vertex->point().x() * across + vertex->point().y() * up + plane.offset * plane.normal);
      }
      corners[k] = vertex->info().number;
    }
    side.triangles.push_back(corners);
  }
}

/// Sets of triangles connected by edges, each with the vertices that it uses.
std::vector<geometry::TriangleMesh> connected(const geometry::TriangleMesh& mesh) {
  UnionFind joined(mesh.triangles.size());
  for (const auto& edge : shared_edges(mesh)) joined.join(edge.left, edge.right);
  std::map<std::size_t, std::size_t> place;
  std::vector<geometry::TriangleMesh> parts;
  std::vector<std::vector<int>> numbers;
  for (std::size_t t = 0; t < joined.size(); ++t) {
    const auto [found, fresh] = place.try_emplace(joined.find(t), parts.size());
    if (fresh) {
      parts.emplace_back();
      numbers.emplace_back(mesh.vertices.size(), -1);
    }
    geometry::TriangleMesh& part = parts[found->second];
    std::array<int, 3> corners = mesh.triangles[t];
    for (int& v : corners) {
      int& number = numbers[found->second][v];
      if (number < 0) {
        number = static_cast<int>(part.vertices.size());
        part.vertices.push_back(mesh.vertices[v]);
      }
      v = number;
    }
    part.triangles.push_back(corners);
  }
  return parts;
}

}  // namespace

std::vector<geometry::TriangleMesh> below(const geometry::TriangleMesh& piece, const HalfSpace& plane) {
  const std::vector<double> heights = heights_over(plane, piece);
  const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
  if (heights.empty() || *lowest >= 0 || *highest <= 0) return {};
  geometry::TriangleMesh side = surface_below(piece, plane, heights);
  add_cap(side, plane, rim_of(side, heights));
  std::vector<geometry::TriangleMesh> parts = connected(side);
  constexpr double k_least_share = 1e-9;  // share of the piece: smaller slivers are rounding
  const double least = k_least_share * geometry::signed_volume(piece);
  std::erase_if(parts, [&](const geometry::TriangleMesh& part) { return !(geometry::signed_volume(part) > least); });
  return parts;
}

std::vector<geometry::TriangleMesh> cut(const geometry::TriangleMesh& piece, const HalfSpace& plane) {
  std::vector<geometry::TriangleMesh> pieces = below(piece, plane),
                                      above = below(piece, {-plane.normal, -plane.offset});
  if (pieces.empty() || above.empty()) return {};
  for (auto& part : above) pieces.push_back(std::move(part));
  const double whole = geometry::signed_volume(piece);
  double volume = 0;
  for (const auto& part : pieces) volume += geometry::signed_volume(part);
  constexpr double k_lost = 1e-5;  // share of the volume: a cut that loses more has failed
  if (std::abs(volume - whole) > k_lost * whole) return {};
  return pieces;
}

}  // namespace nilas::mesh
