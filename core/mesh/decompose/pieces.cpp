#include "core/mesh/decompose/pieces.h"

#include <CGAL/convex_hull_3.h>

#include <algorithm>

#include "core/base/union_find.h"
#include "core/geometry/weld.h"
#include "core/mesh/mend/surface_mesh.h"

namespace nilas::mesh {

namespace {

bool comes_before(const Vec3& p, const Vec3& q) {
  return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
}

/// Number of the facet of each face: faces in one plane that meet in edges are one facet.
std::vector<std::size_t> facets_of(const SurfaceMesh& hull) {
  UnionFind joined(hull.num_faces());
  for (const auto e : hull.edges()) {
    const auto h = hull.halfedge(e), o = hull.opposite(h);
    const auto beyond = [&](const auto& side) { return hull.point(hull.target(hull.next(side))); };
    if (CGAL::coplanar(hull.point(hull.source(h)), hull.point(hull.target(h)), beyond(h), beyond(o)))
      joined.join(hull.face(o), hull.face(h));
  }
  std::vector<std::size_t> facet;
  for (std::size_t f = 0; f < joined.size(); ++f) facet.push_back(joined.find(f));
  return facet;
}

/// Corners of each facet in order, without points on its sides, the first in x, y, z first.
std::vector<std::vector<Vec3>> outlines(const SurfaceMesh& hull) {
  const std::vector<std::size_t> facet = facets_of(hull);
  const auto outside = [&](const auto h) { return facet[hull.face(hull.opposite(h))] != facet[hull.face(h)]; };
  const auto next = [&](auto h) {
    for (h = hull.next(h); !outside(h);) h = hull.next(hull.opposite(h));
    return h;
  };
  std::vector<bool> done(facet.size(), false);
  std::vector<std::vector<Vec3>> loops;
  for (const auto start : hull.halfedges()) {
    if (!outside(start) || done[facet[hull.face(start)]]) continue;
    done[facet[hull.face(start)]] = true;
    auto& loop = loops.emplace_back();
    auto h = start;
    do {
      const auto after = next(h);
      const auto &p = hull.point(hull.source(h)), &q = hull.point(hull.target(h)), &r = hull.point(hull.target(after));
      if (!CGAL::collinear(p, q, r)) loop.push_back(to_vec(q));
      h = after;
    } while (h != start);
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end(), comes_before), loop.end());
  }
  return loops;
}

}  // namespace

geometry::TriangleMesh convex_hull(const std::vector<Vec3>& points) {
  if (points.size() < 4) return {};
  std::vector<Kernel::Point_3> given;
  for (const auto& p : points) given.push_back(to_point(p));
  SurfaceMesh hull;
  CGAL::convex_hull_3(given.begin(), given.end(), hull);
  if (!CGAL::is_closed(hull) || hull.num_faces() < 4) return {};
  // CGAL sorts by address, so its triangles depend on other memory contents; the facets do not.
  auto loops = outlines(hull);
  std::sort(loops.begin(), loops.end(), [](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), comes_before);
  });
  geometry::Weld weld;
  for (const auto& loop : loops)
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) weld.add({loop[0], loop[k], loop[k + 1]});
  return weld.take();
}

std::vector<SharedEdge> shared_edges(const geometry::TriangleMesh& mesh) {
  struct Use {
    int low, high;
    bool back;
    std::size_t triangle;
    auto operator<=>(const Use&) const = default;
  };
  std::vector<Use> uses;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), a > b, t});
    }
  std::sort(uses.begin(), uses.end());
  std::vector<SharedEdge> edges;
  for (auto first = uses.begin(); first != uses.end();) {
    const auto same = [&](const Use& use) { return use.low == first->low && use.high == first->high; };
    const auto last = std::find_if_not(first, uses.end(), same);
    auto back = std::find_if(first, last, [](const Use& use) { return use.back; });
    for (auto there = first; there != last && !there->back && back != last; ++there, ++back)
      edges.push_back({there->low, there->high, there->triangle, back->triangle});
    first = last;
  }
  return edges;
}

}  // namespace nilas::mesh
