#include "core/geometry/coplanar_groups.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/error.h"

namespace nilas::geometry {

namespace {

struct Plane {
  Vec3 normal;
  double offset;  ///< normal . x on the plane [m]
};

/// Grows groups over one mesh, a group after the other.
class GroupGrowth {
 public:
  GroupGrowth(const TriangleMesh& mesh, const std::vector<std::array<int, 3>>& neighbours, double tolerance)
      : mesh_(mesh), neighbours_(neighbours), tolerance_(tolerance), taken_(mesh.triangles.size(), false) {
    visit_.assign(mesh.triangles.size(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Vec3 a = corner(t, 0), ab = corner(t, 1) - a, ac = corner(t, 2) - a;
      area_vectors_.push_back(0.5 * ab.cross(ac));
      const double longest = std::sqrt(std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()}));
      heights_.push_back(longest > 0 ? 2 * area_vectors_.back().norm() / longest : 0);
    }
  }

  double area(int t) const { return area_vectors_[t].norm(); }
  bool taken(int t) const { return taken_[t]; }

  /// Largest group around `seed`, whose triangles are then taken. The plane is fitted anew while the group grows: one
  /// small triangle with rounded vertices fixes the plane of a long face poorly.
  std::vector<int> take_group(int seed) {
    constexpr int k_fits = 12;  // each fit widens the group several times over, so this spans any mesh
    std::vector<int> group = grow(seed, fitted_plane({seed}));
    for (int fit = 1; fit < k_fits && group.size() > 1; ++fit) {
      std::vector<int> wider = grow(seed, fitted_plane(group));
      if (wider.size() <= group.size()) break;
      group = std::move(wider);
    }
    for (const int t : group) taken_[t] = true;
    return group;
  }

 private:
  const Vec3& corner(std::size_t t, std::size_t k) const { return mesh_.vertices[mesh_.triangles[t][k]]; }

  /// Plane through the centroid of the group's area, normal to its area vector.
  Plane fitted_plane(const std::vector<int>& group) const {
    Vec3 sum = Vec3::Zero(), first = Vec3::Zero();
    double areas = 0;
    for (const int t : group) {
      sum += area_vectors_[t];
      areas += area(t);
      first += area(t) / 3 * (corner(t, 0) + corner(t, 1) + corner(t, 2));
    }
    const Vec3 normal = sum.normalized();
    return {normal, areas > 0 ? normal.dot(first) / areas : normal.dot(corner(group[0], 0))};
  }

  bool fits(int t, const Plane& plane) const {
    const bool thin = heights_[t] <= tolerance_;
    if (!thin && plane.normal.dot(area_vectors_[t]) <= 0.5 * area(t)) return false;
    const double allowed = tolerance_ + (thin ? heights_[t] : 0);
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(plane.normal.dot(corner(t, k)) - plane.offset) > allowed) return false;
    return true;
  }

  std::vector<int> grow(int seed, const Plane& plane) {
    ++visits_;
    visit_[seed] = visits_;
    std::vector<int> group{seed};
    for (std::size_t k = 0; k < group.size(); ++k)
      for (const int other : neighbours_[group[k]]) {
        if (visit_[other] == visits_ || taken_[other]) continue;
        visit_[other] = visits_;
        if (fits(other, plane)) group.push_back(other);
      }
    return group;
  }

  const TriangleMesh& mesh_;
  const std::vector<std::array<int, 3>>& neighbours_;
  double tolerance_;
  std::vector<Vec3> area_vectors_;  ///< [m^2]
  std::vector<double> heights_;     ///< height of each triangle over its longest edge [m]
  std::vector<bool> taken_;
  std::vector<int> visit_;  ///< number of the visit that saw the triangle last
  int visits_ = 0;
};

}  // namespace

std::vector<std::array<int, 3>> triangle_neighbours(const TriangleMesh& mesh) {
  struct DirectedEdge {
    int from, to, triangle, place;
  };
  std::vector<DirectedEdge> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      edges.push_back({mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3], static_cast<int>(t), static_cast<int>(k)});
  const auto before = [](const DirectedEdge& a, const DirectedEdge& b) {
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  };
  std::sort(edges.begin(), edges.end(), before);
  std::vector<std::array<int, 3>> neighbours(mesh.triangles.size());
  for (const auto& edge : edges) {
    const auto twin = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{edge.to, edge.from, 0, 0}, before);
    NILAS_DEMAND(twin != edges.end() && twin->from == edge.to && twin->to == edge.from);
    neighbours[edge.triangle][edge.place] = twin->triangle;
  }
  return neighbours;
}

std::vector<std::vector<int>> coplanar_groups(const TriangleMesh& mesh,
                                              const std::vector<std::array<int, 3>>& neighbours, double tolerance) {
  GroupGrowth growth(mesh, neighbours, tolerance);
  // large triangles first: their planes are the best determined
  std::vector<int> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return growth.area(a) > growth.area(b); });
  std::vector<std::vector<int>> groups;
  for (const int seed : order)
    if (!growth.taken(seed)) groups.push_back(growth.take_group(seed));
  return groups;
}

}  // namespace nilas::geometry
