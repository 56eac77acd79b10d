#pragma once
/// Solids and outlines with known answers, shared by the tests of this folder.
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "core/base/random.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/mesh.h"

namespace nilas::bodies {

inline const std::vector<Vec2>& l_outline() {
  static const std::vector<Vec2> outline{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}};
  return outline;
}

/// Regular star of `arms` arms: vertices alternate between the two radii.
inline std::vector<Vec2> star_outline(int arms, double outer, double inner) {
  std::vector<Vec2> outline;
  for (int i = 0; i < 2 * arms; ++i) {
    const double r = i % 2 == 0 ? outer : inner, angle = k_pi * i / arms;
    outline.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return outline;
}

/// Simple polygon seen whole from the origin: sorted random angles, random radii.
inline std::vector<Vec2> random_star_polygon(RandomStream& random) {
  const int n = 4 + static_cast<int>(random.uniform(0, 27));
  std::vector<double> angles;
  for (int i = 0; i < n; ++i) angles.push_back(2 * k_pi * (i + random.uniform(0.0, 0.9)) / n);
  std::vector<Vec2> outline;
  for (const double angle : angles) {
    const double r = random.uniform(0.2, 1.0);
    outline.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return outline;
}

/// Each triangle cut into four; points on shared edges stay shared.
inline geometry::TriangleMesh subdivided(const geometry::TriangleMesh& mesh) {
  geometry::TriangleMesh fine{mesh.vertices, {}};
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [found, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<int>(fine.vertices.size()));
    if (fresh) fine.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
    return found->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return fine;
}

inline geometry::TriangleMesh octahedron() {
  return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
          {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}, {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}}};
}

/// 8 * 4^levels triangles on the sphere about the origin.
inline geometry::TriangleMesh sphere_mesh(double radius, int levels) {
  geometry::TriangleMesh mesh = octahedron();
  for (int level = 0; level < levels; ++level) {
    mesh = subdivided(mesh);
    for (auto& p : mesh.vertices) p.normalize();
  }
  for (auto& p : mesh.vertices) p *= radius;
  return mesh;
}

inline geometry::TriangleMesh moved(geometry::TriangleMesh mesh, const Mat3& R, const Vec3& p) {
  for (auto& x : mesh.vertices) x = R * x + p;
  return mesh;
}

}  // namespace nilas::bodies
