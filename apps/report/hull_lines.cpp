#include "apps/report/hull_lines.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/geometry/edge_cut.h"

namespace nilas::report {

namespace {

Vec3 normal_of(const geometry::TriangleMesh& mesh, const std::array<int, 3>& triangle) {
  const auto corner = [&](int k) { return mesh.vertices[triangle[k]]; };
  return (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
}

}  // namespace

std::vector<Segment> visible_lines(const geometry::TriangleMesh& mesh, const Vec3& from) {
  constexpr double k_sharp = 20 * k_deg, k_edge_on = 1e-6;
  std::map<std::pair<int, int>, Vec3> first_side;  // normal of the triangle met first
  std::vector<Segment> lines;
  for (const auto& triangle : mesh.triangles) {
    const Vec3 n = normal_of(mesh, triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = triangle[k], j = triangle[(k + 1) % 3];
      const auto [place, is_new] = first_side.try_emplace(std::minmax(i, j), n);
      if (is_new) continue;
      const Vec3& other = place->second;
      const bool near = n.dot(from) > k_edge_on, other_near = other.dot(from) > k_edge_on;
      const bool sharp = n.dot(other) < std::cos(k_sharp) && (near || other_near);
      if (near != other_near || sharp) lines.push_back({mesh.vertices[i], mesh.vertices[j]});
    }
  }
  return lines;
}

std::vector<Segment> waterline(const geometry::TriangleMesh& mesh, double level) {
  std::vector<Segment> lines;
  for (const auto& triangle : mesh.triangles) {
    std::vector<Vec3> cut;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = mesh.vertices[triangle[k]], &b = mesh.vertices[triangle[(k + 1) % 3]];
      if (const auto point = geometry::edge_cut(a, b, level)) cut.push_back(*point);
    }
    if (cut.size() == 2) lines.push_back({cut[0], cut[1]});
  }
  return lines;
}

}  // namespace nilas::report
