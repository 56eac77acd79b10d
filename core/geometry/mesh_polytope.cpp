/// Convex polytope of a triangle mesh.
#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/error.h"
#include "core/geometry/coplanar_faces.h"
#include "core/geometry/shape.h"

namespace nilas::geometry {

namespace {

void drop_unused_vertices(ConvexPolytope& p) {
  std::vector<int> fresh(p.vertices.size(), -1);
  std::vector<Vec3> kept;
  for (auto& loop : p.faces)
    for (int& v : loop) {
      if (fresh[v] < 0) {
        fresh[v] = static_cast<int>(kept.size());
        kept.push_back(p.vertices[v]);
      }
      v = fresh[v];
    }
  p.vertices = std::move(kept);
}

/// Mean width of a face: how firmly its vertices hold its plane [m].
double face_width(const ConvexPolytope& p, std::size_t f) {
  const auto& loop = p.faces[f];
  Vec3 twice_area = Vec3::Zero();
  double perimeter = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 &a = p.vertices[loop[i]], &b = p.vertices[loop[(i + 1) % loop.size()]];
    twice_area += (a - p.centre).cross(b - p.centre);
    perimeter += (b - a).norm();
  }
  return twice_area.norm() / perimeter;
}

[[noreturn]] void not_convex(const Vec3& vertex, double above) {
  std::array<char, 160> text{};
  std::snprintf(
      text.data(), text.size(),
      "the surface is not convex: the vertex at (%.6g, %.6g, %.6g) m stands %.3g m outside the plane of a face",
      vertex.x(), vertex.y(), vertex.z(), above);
  throw InputError(text.data());
}

/// Every vertex against every face plane: a finely meshed hollow bends too little per edge to show at its edges. A face
/// whose vertices are rounded by `rounding` may tilt by rounding over its width.
void demand_convex(const ConvexPolytope& p, double tolerance, double rounding) {
  Eigen::MatrixX3d x(static_cast<Eigen::Index>(p.vertices.size()), 3);
  for (std::size_t v = 0; v < p.vertices.size(); ++v) x.row(static_cast<Eigen::Index>(v)) = p.vertices[v];
  VecX above(x.rows());
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    if (!(p.normals[f].squaredNorm() > 0.5)) throw InputError("the surface has a face without area");
    above.noalias() = x * p.normals[f];
    if (above.maxCoeff() - p.offsets[f] <= tolerance) continue;
    const double tilt = rounding / face_width(p, f);
    for (std::size_t v = 0; v < p.vertices.size(); ++v) {
      const double height = above[static_cast<Eigen::Index>(v)] - p.offsets[f];
      if (height > tolerance + tilt * (p.vertices[v] - p.vertices[p.faces[f][0]]).norm())
        not_convex(p.vertices[v], height);
    }
  }
}

}  // namespace

ConvexPolytope make_polytope(const TriangleMesh& mesh, double tolerance) {
  const MeshDefects defects = find_defects(mesh);
  if (!defects.closed() || defects.inward)
    throw InputError("the surface is not a closed outward solid: " + defects.text());
  TriangleMesh solid = mesh;
  std::erase_if(solid.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  constexpr double k_flat_share = 0.05;  // merged faces stay far flatter than the convexity asked for
  const double flat = k_flat_share * tolerance;
  ConvexPolytope p;
  p.vertices = solid.vertices;
  p.faces = coplanar_faces(solid, flat);
  drop_unused_vertices(p);
  complete(p);
  demand_convex(p, tolerance, flat);
  return p;
}

}  // namespace nilas::geometry
