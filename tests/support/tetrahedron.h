#pragma once
#include <utility>

#include "core/geometry/mesh.h"

namespace nilas::test {

/// The closed surface of the tetrahedron of four corners in any order; its triangles face outward.
inline geometry::TriangleMesh tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  geometry::TriangleMesh mesh{{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  if (geometry::signed_volume(mesh) < 0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace nilas::test
