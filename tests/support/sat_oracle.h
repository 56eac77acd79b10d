#pragma once
/// Brute-force truth for two convex polytopes: every face normal and every pair of edges, every pair of features. Slow
/// and simple on purpose; shares no code with contact/detect.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/bodies/shape.h"

namespace nilas::oracle {

/// A polytope at a pose.
struct Solid {
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> faces;
  std::vector<Vec3> normals;
  std::vector<std::pair<int, int>> edges;
};

inline Solid posed(const ConvexPolytope& polytope, const Mat3& R, const Vec3& p) {
  Solid solid;
  for (const Vec3& v : polytope.vertices) solid.vertices.push_back(R * v + p);
  solid.faces = polytope.faces;
  for (const auto& loop : polytope.faces) {
    Vec3 area = Vec3::Zero();
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int i = loop[k], j = loop[(k + 1) % loop.size()];
      area += (solid.vertices[i] - solid.vertices[loop[0]]).cross(solid.vertices[j] - solid.vertices[loop[0]]);
      if (i < j) solid.edges.emplace_back(i, j);
    }
    solid.normals.push_back(area.normalized());
  }
  return solid;
}

inline Solid posed(const Bodies& bodies, int b, int part = 0) {
  return posed(bodies.shape[b]->parts[part], bodies.R_GB[b], bodies.p_GB[b]);
}

/// Least n . x over b minus largest over a.
inline double separation(const Solid& a, const Solid& b, const Vec3& n) {
  double high = -std::numeric_limits<double>::infinity(), low = std::numeric_limits<double>::infinity();
  for (const Vec3& v : a.vertices) high = std::max(high, n.dot(v));
  for (const Vec3& v : b.vertices) low = std::min(low, n.dot(v));
  return low - high;
}

struct SeparatingAxis {
  Vec3 n = Vec3::UnitX();  ///< from a to b
  double s = -std::numeric_limits<double>::infinity();
};

/// All candidate axes with their separations, best first.
inline std::vector<SeparatingAxis> all_axes(const Solid& a, const Solid& b) {
  std::vector<SeparatingAxis> axes;
  const auto add = [&](const Vec3& n) { axes.push_back({n, separation(a, b, n)}); };
  for (const Vec3& n : a.normals) add(n);
  for (const Vec3& n : b.normals) add(-n);
  for (const auto& [i, j] : a.edges)
    for (const auto& [k, l] : b.edges) {
      const Vec3 along_a = (a.vertices[j] - a.vertices[i]).normalized();
      const Vec3 along_b = (b.vertices[l] - b.vertices[k]).normalized();
      const Vec3 n = along_a.cross(along_b);
      constexpr double k_parallel = 1e-9;
      if (n.norm() < k_parallel) continue;
      add(n.normalized());
      add(-n.normalized());
    }
  std::sort(axes.begin(), axes.end(), [](const auto& p, const auto& q) { return p.s > q.s; });
  return axes;
}

inline double distance_to_triangle_plane(const Solid& solid, int face, const Vec3& x) {
  const auto& loop = solid.faces[face];
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec3& p = solid.vertices[loop[k]];
    const Vec3& q = solid.vertices[loop[(k + 1) % loop.size()]];
    if ((q - p).cross(solid.normals[face]).dot(x - p) > 0) return std::numeric_limits<double>::infinity();
  }
  return std::abs(solid.normals[face].dot(x - solid.vertices[loop[0]]));
}

inline double distance_of_segments(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
  const auto to_segment = [](const Vec3& x, const Vec3& s0, const Vec3& s1) {
    const double t = std::clamp((x - s0).dot(s1 - s0) / (s1 - s0).squaredNorm(), 0.0, 1.0);
    return (s0 + t * (s1 - s0) - x).norm();
  };
  double least =
      std::min({to_segment(p0, q0, q1), to_segment(p1, q0, q1), to_segment(q0, p0, p1), to_segment(q1, p0, p1)});
  const Vec3 d = p1 - p0, e = q1 - q0, n = d.cross(e);
  constexpr double k_parallel = 1e-9;
  if (n.norm() <= k_parallel * d.norm() * e.norm()) return least;
  const double t = (q0 - p0).cross(e).dot(n) / n.squaredNorm();
  const double u = (q0 - p0).cross(d).dot(n) / n.squaredNorm();
  if (t >= 0 && t <= 1 && u >= 0 && u <= 1) least = std::min(least, std::abs((q0 - p0).dot(n.normalized())));
  return least;
}

/// Distance of two solids that are apart.
inline double distance(const Solid& a, const Solid& b) {
  double least = std::numeric_limits<double>::infinity();
  for (int f = 0; f < static_cast<int>(a.faces.size()); ++f)
    for (const Vec3& v : b.vertices) least = std::min(least, distance_to_triangle_plane(a, f, v));
  for (int f = 0; f < static_cast<int>(b.faces.size()); ++f)
    for (const Vec3& v : a.vertices) least = std::min(least, distance_to_triangle_plane(b, f, v));
  for (const auto& [i, j] : a.edges)
    for (const auto& [k, l] : b.edges)
      least = std::min(least, distance_of_segments(a.vertices[i], a.vertices[j], b.vertices[k], b.vertices[l]));
  return least;
}

}  // namespace nilas::oracle
