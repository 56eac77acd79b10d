#include "core/mesh/decompose/surface_distance.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <queue>

#include "core/geometry/mesh_box.h"
#include "core/mesh/decompose/union_surface.h"

namespace nilas::mesh {

namespace {

// Distances and ray tests need no exact predicates, which cost ten times as much.
using Fast = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Fast::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Fast, Triangles::iterator>;
using BoxTree = CGAL::AABB_tree<CGAL::AABB_traits<Fast, Primitive>>;

Fast::Point_3 fast(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
Vec3 vec(const Fast::Point_3& p) { return {p.x(), p.y(), p.z()}; }

Triangles triangles_for_tree(const std::vector<Corners>& surface) {
  Triangles triangles;
  for (const auto& c : surface) {
    const Fast::Triangle_3 t(fast(c[0]), fast(c[1]), fast(c[2]));
    if (!t.is_degenerate()) triangles.push_back(t);
  }
  return triangles;
}

/// The two halves on either side of the longest edge's middle.
std::array<Corners, 2> halves(const Corners& t) {
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if ((t[(k + 1) % 3] - t[k]).squaredNorm() > (t[(longest + 1) % 3] - t[longest]).squaredNorm()) longest = k;
  const Vec3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3], m = 0.5 * (a + b);
  return {Corners{a, m, c}, Corners{m, b, c}};
}

}  // namespace

std::vector<Corners> corners_of(const geometry::TriangleMesh& mesh) {
  std::vector<Corners> out;
  for (const auto& t : mesh.triangles) {
    Corners& c = out.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) c[k] = mesh.vertices[t[k]];
  }
  return out;
}

struct SurfaceDistance::Tree {
  explicit Tree(const std::vector<Corners>& surface)
      : triangles(triangles_for_tree(surface)), boxes(triangles.begin(), triangles.end()) {
    boxes.accelerate_distance_queries();
  }

  /// Point of the surface and its triangle.
  using Place = BoxTree::Point_and_primitive_id;
  Place nearest(const Vec3& p) const { return boxes.closest_point_and_primitive(fast(p)); }
  /// The nearest point; `near` is the result for a point close by.
  Place nearest(const Vec3& p, const Place& near) const { return boxes.closest_point_and_primitive(fast(p), near); }

  /// Whether the surface does not meet the triangle, except in a rim of a millionth of it.
  bool clear_of(const Corners& t) const {
    constexpr double k_rim = 1e-6;
    const Vec3 m = (t[0] + t[1] + t[2]) / 3;
    std::array<Fast::Point_3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = fast(t[k] + k_rim * (m - t[k]));
    const Fast::Triangle_3 shrunk(p[0], p[1], p[2]);
    try {
      return !shrunk.is_degenerate() && !boxes.do_intersect(shrunk);
    } catch (const CGAL::Precondition_exception&) {
      return false;  // too narrow for the test in doubles
    }
  }

  bool inside(const Vec3& p) const {
    const bool first = odd_crossings(p, {0.42971, 0.31013, 0.84799}),
               second = odd_crossings(p, {-0.7417, 0.1873, -0.6440});
    return first == second ? first : odd_crossings(p, {0.1299, -0.8531, 0.5053});
  }

  Triangles triangles;
  BoxTree boxes;

 private:
  /// Whether a ray crosses the surface an odd number of times. A ray may touch an edge, so several directions are
  /// tried, none along an axis or a diagonal.
  bool odd_crossings(const Vec3& p, const Fast::Vector_3& direction) const {
    return boxes.number_of_intersected_primitives(Fast::Ray_3(fast(p), direction)) % 2 == 1;
  }
};

SurfaceDistance::SurfaceDistance(std::vector<Corners> surface) : tree_(std::make_unique<Tree>(surface)) {}
SurfaceDistance::~SurfaceDistance() = default;

double SurfaceDistance::at(const Vec3& p) const { return (vec(tree_->nearest(p).first) - p).norm(); }

double SurfaceDistance::outside(const Vec3& p) const { return tree_->inside(p) ? 0 : at(p); }

namespace {

/// The triangle as planes along its edges, wider by `skin`; empty unless it lies in the plane.
std::vector<HalfSpace> edge_planes(const Fast::Triangle_3& triangle, const HalfSpace& plane, double skin) {
  Corners c;
  for (std::size_t k = 0; k < 3; ++k) c[k] = vec(triangle[static_cast<int>(k)]);
  for (const auto& p : c)
    if (std::abs(plane.height(p)) > skin) return {};
  const Vec3 up = (c[1] - c[0]).cross(c[2] - c[0]).normalized();
  std::vector<HalfSpace> planes;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 out = (c[(k + 1) % 3] - c[k]).cross(up).normalized();
    planes.push_back({out, out.dot(c[k]) + skin});
  }
  return planes;
}

}  // namespace

std::vector<Corners> SurfaceDistance::without_shared_faces(const std::vector<Corners>& triangles, double skin) const {
  std::vector<Corners> off;
  for (const auto& t : triangles) {
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    if (!normal.allFinite()) continue;
    const HalfSpace plane{normal, normal.dot(t[0])};
    CGAL::Bbox_3 box;
    for (const auto& c : t)
      box += CGAL::Bbox_3(c.x() - skin, c.y() - skin, c.z() - skin, c.x() + skin, c.y() + skin, c.z() + skin);
    std::vector<Triangles::iterator> near;
    tree_->boxes.all_intersected_primitives(box, std::back_inserter(near));
    std::vector<Loop> left{{t[0], t[1], t[2]}};
    for (const auto& face : near) {
      const auto planes = edge_planes(*face, plane, skin);
      if (planes.empty()) continue;
      std::vector<Loop> next;
      for (const auto& loop : left) subtract(loop, Vec3::Zero(), planes, next);
      left = std::move(next);
      if (left.empty()) break;
    }
    for (const auto& loop : left)
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) off.push_back({loop[0], loop[i], loop[i + 1]});
  }
  return off;
}

Deviation SurfaceDistance::largest(const std::vector<Corners>& triangles, const DistanceSearch& search) const {
  struct Open {
    double bound;
    Corners triangle;
    Tree::Place nearest;
    bool operator<(const Open& other) const { return bound < other.bound; }
  };
  std::priority_queue<Open> open;
  Deviation found;
  const auto enough = [&] { return std::max((1 + search.slack) * found.largest, search.floor) + search.precision; };
  const auto consider = [&](const Corners& t, const Tree::Place* near) {
    const Vec3 p = (t[0] + t[1] + t[2]) / 3;
    double reach = 0, convex = 0;
    for (const auto& c : t) reach = std::max(reach, (c - p).norm());
    const Tree::Place nearest = near ? tree_->nearest(p, *near) : tree_->nearest(p);
    const double distance = (vec(nearest.first) - p).norm();
    // the distance to one triangle is convex, so largest in a corner
    for (const auto& c : t) convex = std::max(convex, CGAL::squared_distance(fast(c), *nearest.second));
    double bound = std::min(distance + reach, std::sqrt(convex));
    if (bound <= enough() && distance <= found.largest) return;
    if (search.outside_only && tree_->inside(p)) {
      // A path to the outside crosses the surface, so at most the rest of `reach` leads away from there.
      bound = std::min(bound, reach - distance);
      if (bound > enough() && tree_->clear_of(t)) return;
    } else if (distance > found.largest) {
      found.largest = distance;
      found.place = p;
    }
    if (bound > enough()) open.push({bound, t, nearest});
  };
  for (const auto& t : triangles) consider(t, nullptr);
  constexpr int k_most_cuts = 4'000'000;  // takes some seconds; the remaining triangles are reported as unmeasured
  int cuts = 0;
  while (!open.empty() && open.top().bound > enough() && found.largest <= search.ceiling && cuts++ < k_most_cuts) {
    const Open worst = open.top();
    open.pop();
    for (const auto& half : halves(worst.triangle)) consider(half, &worst.nearest);
  }
  found.unmeasured = search.precision + search.slack * found.largest;
  if (cuts > k_most_cuts) found.unmeasured = std::max(found.unmeasured, open.top().bound - found.largest);
  return found;
}

double asymmetry(const geometry::TriangleMesh& mesh) {
  constexpr double k_skin = 1e-6, k_precision = 2e-6,
                   k_slack = 0.02;  // two shares of the size, and a share of the found distance
  const double size = geometry::box_of(mesh).sizes().maxCoeff();
  std::vector<Corners> images = corners_of(mesh);
  const SurfaceDistance surface(images);
  double corners = 0;
  for (auto& t : images)
    for (auto& p : t) {
      p.y() = -p.y();
      corners = std::max(corners, surface.at(p));
    }
  // corners may lie on the surface where the faces between them do not: sides cut along other diagonals
  const DistanceSearch search{.precision = k_precision * size, .floor = corners, .slack = k_slack};
  return std::max(corners, surface.largest(surface.without_shared_faces(images, k_skin * size), search).largest);
}

}  // namespace nilas::mesh
