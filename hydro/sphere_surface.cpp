#include "hydro/sphere_surface.h"

#include <cmath>

namespace nilas::hydro {

namespace {

constexpr int k_cuts = 8;  // of each octahedron edge

/// Adds one octant of the unit sphere. `sign` holds the signs of x, y and z.
void add_octant(const Vec3& sign, geometry::TriangleMesh& mesh) {
  const int first = static_cast<int>(mesh.vertices.size());
  const auto index = [&](int i, int j) { return first + i * (k_cuts + 1) - i * (i - 1) / 2 + j; };
  for (int i = 0; i <= k_cuts; ++i)
    for (int j = 0; i + j <= k_cuts; ++j)
      mesh.vertices.push_back(Vec3(i, j, k_cuts - i - j).cwiseProduct(sign).normalized());
  const bool flip = sign.prod() < 0;
  const auto add = [&](int a, int b, int c) {
    mesh.triangles.push_back(flip ? std::array{a, c, b} : std::array{a, b, c});
  };
  for (int i = 0; i < k_cuts; ++i)
    for (int j = 0; i + j < k_cuts; ++j) {
      add(index(i, j), index(i + 1, j), index(i, j + 1));
      if (i + j + 1 < k_cuts) add(index(i + 1, j + 1), index(i, j + 1), index(i + 1, j));
    }
}

double surface_area(const geometry::TriangleMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& corner = mesh.vertices[a];
    area += 0.5 * (mesh.vertices[b] - corner).cross(mesh.vertices[c] - corner).norm();
  }
  return area;
}

}  // namespace

geometry::TriangleMesh sphere_surface(double radius) {
  constexpr double k_unit_sphere = 4 * k_pi;  // area [m^2]
  geometry::TriangleMesh mesh;
  for (const double x : {1.0, -1.0})
    for (const double y : {1.0, -1.0})
      for (const double z : {1.0, -1.0}) add_octant({x, y, z}, mesh);
  const double scale = radius * std::sqrt(k_unit_sphere / surface_area(mesh));
  for (Vec3& vertex : mesh.vertices) vertex *= scale;
  return mesh;
}

}  // namespace nilas::hydro
