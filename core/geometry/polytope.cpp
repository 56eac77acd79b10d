/// Convex polytopes: what follows from vertices and faces; prisms and boxes.
#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/base/order_free_sum.h"
#include "core/geometry/shape.h"

namespace nilas::geometry {

namespace {

/// Twice the area vector of a loop.
Vec3 area_vector(const std::vector<Vec3>& vertices, const std::vector<int>& loop) {
  OrderFreeVectorSum middle, area;
  for (const int v : loop) middle.add(vertices[v]);
  const Vec3 origin = middle.value() / static_cast<double>(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i)
    area.add((vertices[loop[i]] - origin).cross(vertices[loop[(i + 1) % loop.size()]] - origin));
  return area.value();
}

void fill_centre(ConvexPolytope& p) {
  OrderFreeVectorSum sum;
  for (const auto& x : p.vertices) sum.add(x);
  p.centre = sum.value() / static_cast<double>(p.vertices.size());
  p.radius = 0;
  for (const auto& x : p.vertices) p.radius = std::max(p.radius, (x - p.centre).norm());
}

void fill_planes(ConvexPolytope& p) {
  Eigen::MatrixX3d x(static_cast<Eigen::Index>(p.vertices.size()), 3);
  for (std::size_t v = 0; v < p.vertices.size(); ++v) x.row(static_cast<Eigen::Index>(v)) = p.vertices[v];
  VecX heights(x.rows());
  p.normals.clear();
  p.offsets.clear();
  p.smallest_width = std::numeric_limits<double>::infinity();
  for (const auto& loop : p.faces) {
    const Vec3 n = area_vector(p.vertices, loop).normalized();
    heights.noalias() = x * n;
    double offset = -std::numeric_limits<double>::infinity();
    for (const int v : loop) offset = std::max(offset, n.dot(p.vertices[v]));
    p.normals.push_back(n);
    p.offsets.push_back(offset);
    p.smallest_width = std::min(p.smallest_width, offset - heights.minCoeff());
  }
}

void fill_adjacency(ConvexPolytope& p) {
  p.vertex_faces.assign(p.vertices.size(), {});
  p.vertex_neighbours.assign(p.vertices.size(), {});
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    const auto& loop = p.faces[f];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int v = loop[i], next = loop[(i + 1) % loop.size()];
      p.vertex_faces[v].push_back(static_cast<int>(f));
      p.vertex_neighbours[v].push_back(next);
      p.vertex_neighbours[next].push_back(v);
    }
  }
  for (auto& neighbours : p.vertex_neighbours) {
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  }
}

}  // namespace

void complete(ConvexPolytope& p) {
  NILAS_DEMAND(p.vertices.size() >= 4 && p.faces.size() >= 4);
  fill_centre(p);
  fill_planes(p);
  fill_adjacency(p);
}

ConvexPolytope make_prism(const std::vector<Vec2>& outline, double bottom, double top) {
  NILAS_DEMAND(outline.size() >= 3 && top > bottom);
  const int n = static_cast<int>(outline.size());
  ConvexPolytope p;
  for (const double z : {bottom, top})
    for (const auto& x : outline) p.vertices.emplace_back(x.x(), x.y(), z);
  std::vector<int> low, high;
  for (int i = 0; i < n; ++i) {
    low.push_back(n - 1 - i);
    high.push_back(n + i);
  }
  p.faces = {low, high};
  for (int i = 0; i < n; ++i) p.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  complete(p);
  return p;
}

ConvexPolytope make_box(const Vec3& size) {
  const double x = 0.5 * size.x(), y = 0.5 * size.y(), z = 0.5 * size.z();
  return make_prism({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, -z, z);
}

}  // namespace nilas::geometry
