#include "core/geometry/coplanar_faces.h"

#include <algorithm>
#include <limits>
#include <map>

#include "core/geometry/coplanar_groups.h"
#include "core/geometry/polygon.h"

namespace nilas::geometry {

namespace {

/// Outline of a group of triangles, or empty when it is not one simple loop.
std::vector<int> outline_of(const TriangleMesh& mesh, const std::vector<std::array<int, 3>>& neighbours,
                            const std::vector<int>& group, const std::vector<int>& group_of) {
  std::map<int, int> next;
  for (const int t : group)
    for (std::size_t k = 0; k < 3; ++k) {
      if (group_of[neighbours[t][k]] == group_of[t]) continue;
      if (!next.emplace(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]).second) return {};
    }
  if (next.size() < 3) return {};
  std::vector<int> loop;
  int v = next.begin()->first;
  do {
    loop.push_back(v);
    v = next.at(v);
  } while (v != loop.front() && loop.size() < next.size());
  return v == loop.front() && loop.size() == next.size() ? loop : std::vector<int>{};
}

/// The loop seen along its area vector.
std::vector<Vec2> flattened(const TriangleMesh& mesh, const std::vector<int>& loop) {
  const Vec3 origin = mesh.vertices[loop[0]];
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    area += (mesh.vertices[loop[i]] - origin).cross(mesh.vertices[loop[i + 1]] - origin);
  const Vec3 n = area.normalized(), x = n.unitOrthogonal(), y = n.cross(x);
  std::vector<Vec2> flat;
  for (const int v : loop) flat.emplace_back(x.dot(mesh.vertices[v] - origin), y.dot(mesh.vertices[v] - origin));
  return flat;
}

/// True when no vertex lies deeper than `tolerance` inside the hull of all.
bool convex_within(const std::vector<Vec2>& loop, double tolerance) {
  const auto hull = convex_hull(loop);
  if (hull.size() < 3) return false;
  std::vector<double> depth(loop.size(), std::numeric_limits<double>::infinity());
  for (std::size_t e = 0; e < hull.size(); ++e) {
    const Vec2 a = hull[e], along = (hull[(e + 1) % hull.size()] - a).normalized(), inwards(-along.y(), along.x());
    for (std::size_t i = 0; i < loop.size(); ++i) depth[i] = std::min(depth[i], inwards.dot(loop[i] - a));
  }
  return *std::max_element(depth.begin(), depth.end()) <= tolerance;
}

double distance_from_line(const Vec3& p, const Vec3& a, const Vec3& b) {
  return (b - a).normalized().cross(p - a).norm();
}

/// Adds one vote to each vertex between two corners of the loop that lies on the straight line between them.
void vote_straight(const TriangleMesh& mesh, const std::vector<int>& loop, const std::vector<int>& faces_at,
                   double tolerance, std::vector<int>& votes) {
  std::vector<std::size_t> corner_places;
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (faces_at[loop[i]] > 2) corner_places.push_back(i);
  if (corner_places.size() < 3) return;
  for (std::size_t k = 0; k < corner_places.size(); ++k) {
    const std::size_t from = corner_places[k], to = corner_places[(k + 1) % corner_places.size()];
    const Vec3 &a = mesh.vertices[loop[from]], &b = mesh.vertices[loop[to]];
    std::vector<int> between;
    for (std::size_t i = (from + 1) % loop.size(); i != to; i = (i + 1) % loop.size()) between.push_back(loop[i]);
    const bool straight = std::all_of(between.begin(), between.end(),
                                      [&](int v) { return distance_from_line(mesh.vertices[v], a, b) <= tolerance; });
    if (straight)
      for (const int v : between) ++votes[v];
  }
}

/// A vertex goes when both faces at it agree, so that they still share their edge.
void drop_straight_vertices(const TriangleMesh& mesh, double tolerance, std::vector<std::vector<int>>& faces) {
  std::vector<int> faces_at(mesh.vertices.size(), 0), votes(mesh.vertices.size(), 0);
  for (const auto& loop : faces)
    for (const int v : loop) ++faces_at[v];
  for (const auto& loop : faces) vote_straight(mesh, loop, faces_at, tolerance, votes);
  for (auto& loop : faces) std::erase_if(loop, [&](int v) { return votes[v] == 2; });
}

}  // namespace

std::vector<std::vector<int>> coplanar_faces(const TriangleMesh& mesh, double tolerance) {
  const auto neighbours = triangle_neighbours(mesh);
  const auto groups = coplanar_groups(mesh, neighbours, tolerance);
  std::vector<int> group_of(mesh.triangles.size());
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const int t : groups[g]) group_of[t] = static_cast<int>(g);
  std::vector<std::vector<int>> faces;
  for (const auto& group : groups) {
    const auto loop = outline_of(mesh, neighbours, group, group_of);
    if (group.size() > 1 && !loop.empty() && convex_within(flattened(mesh, loop), tolerance)) {
      faces.push_back(loop);
      continue;
    }
    for (const int t : group) faces.emplace_back(mesh.triangles[t].begin(), mesh.triangles[t].end());
  }
  drop_straight_vertices(mesh, tolerance, faces);
  return faces;
}

}  // namespace nilas::geometry
