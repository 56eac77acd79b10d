#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "core/base/parallel.h"
#include "core/geometry/mesh_box.h"
#include "core/mesh/decompose/pieces.h"

namespace nilas::mesh {

namespace {

/// A concave edge, the adjacent normals, and its length times angle [m rad].
struct HollowEdge {
  Vec3 a, b;
  Vec3 left, right;
  double weight;
};

Vec3 normal_of(const Corners& c) { return (c[1] - c[0]).cross(c[2] - c[0]).normalized(); }

std::vector<HollowEdge> hollow_edges(const geometry::TriangleMesh& piece, const std::vector<SharedEdge>& edges) {
  constexpr double k_sharp = 0.05;  // [rad]: less is a curve in facets
  const std::vector<Corners> corners = corners_of(piece);
  std::vector<HollowEdge> found;
  for (const auto& e : edges) {
    const Vec3 &a = piece.vertices[e.a], &b = piece.vertices[e.b];
    const Corners& beyond = corners[e.right];
    const Vec3 left = normal_of(corners[e.left]), right = normal_of(beyond);
    if (!left.allFinite() || !right.allFinite()) continue;
    const double rise = left.dot(beyond[0] + beyond[1] + beyond[2] - 3 * a);
    const double angle = std::acos(std::clamp(left.dot(right), -1.0, 1.0));
    if (rise > 0 && angle > k_sharp) found.push_back({a, b, left, right, angle * (b - a).norm()});
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& e, const auto& f) { return e.weight > f.weight; });
  return found;
}

HalfSpace across(int axis, double place) { return {Vec3::Unit(axis), place}; }

void add_even(const geometry::TriangleMesh& piece, std::vector<HalfSpace>& planes) {
  constexpr int k_slices = 12;
  const auto box = geometry::box_of(piece);
  for (int axis = 0; axis < 3; ++axis)
    for (int k = 1; k < k_slices; ++k)
      planes.push_back(across(axis, box.min()[axis] + box.sizes()[axis] * k / k_slices));
}

/// Adds axis planes through the ends of the most important concave edges, and the planes of the sharpest edges' faces.
void add_hollow(const std::vector<HollowEdge>& edges, std::vector<HalfSpace>& planes) {
  constexpr std::size_t k_levels = 8, k_faces = 6;
  for (int axis = 0; axis < 3; ++axis) {
    std::map<double, double> weight;
    for (const auto& e : edges)
      for (const Vec3& p : {e.a, e.b}) weight[p[axis]] += e.weight;
    std::vector<std::pair<double, double>> levels;
    for (const auto& [place, w] : weight) levels.emplace_back(-w, place);
    std::sort(levels.begin(), levels.end());
    if (levels.size() > k_levels) levels.resize(k_levels);
    for (const auto& [w, place] : levels) planes.push_back(across(axis, place));
  }
  for (std::size_t k = 0; k < std::min(edges.size(), k_faces); ++k)
    for (const Vec3& normal : {edges[k].left, edges[k].right}) planes.push_back({normal, normal.dot(edges[k].a)});
}

using Ends = std::vector<std::pair<Vec3, Vec3>>;

/// Ends of a sample of a piece's edges: of all, or of every n-th where there are more than `most`.
Ends sample_edges(const geometry::TriangleMesh& piece, const std::vector<SharedEdge>& edges, std::size_t most) {
  const std::size_t stride = 1 + edges.size() / most;
  Ends ends;
  for (std::size_t k = 0; k < edges.size(); k += stride)
    ends.emplace_back(piece.vertices[edges[k].a], piece.vertices[edges[k].b]);
  return ends;
}

/// Volume of both sides' convex hulls [m^3]; infinite where the plane leaves a side empty. Points in the plane belong
/// to the side that their edge leads to: a pontoon's top, cut along, is not the column's.
double volume_of_sides(const Ends& edges, const HalfSpace& plane, double skin) {
  std::vector<Vec3> low, high;
  for (const auto& [a, b] : edges) {
    const double ha = plane.height(a), hb = plane.height(b);
    for (const auto& [side, sign] : {std::pair{&low, -1.0}, {&high, 1.0}}) {
      if (sign * ha <= skin && sign * hb <= skin) continue;
      if (sign * ha >= -skin) side->push_back(a);
      if (sign * hb >= -skin) side->push_back(b);
      if (std::min(ha, hb) < -skin && std::max(ha, hb) > skin) side->push_back(a + (ha / (ha - hb)) * (b - a));
    }
  }
  const double below = geometry::signed_volume(convex_hull(low)), above = geometry::signed_volume(convex_hull(high));
  return below > 0 && above > 0 ? below + above : std::numeric_limits<double>::infinity();
}

/// The planes that leave the least volume, the best first.
std::vector<HalfSpace> best_of(const std::vector<HalfSpace>& planes, const Ends& edges, double skin, std::size_t most,
                               int threads) {
  std::vector<std::pair<double, std::size_t>> ranking(planes.size());
  parallel_pieces(std::ssize(planes), threads, [&](std::ptrdiff_t n) {
    const auto k = static_cast<std::size_t>(n);
    ranking[k] = {volume_of_sides(edges, planes[k], skin), k};
  });
  std::erase_if(ranking, [](const auto& row) { return !std::isfinite(row.first); });
  std::sort(ranking.begin(), ranking.end());
  std::vector<HalfSpace> best;
  for (std::size_t k = 0; k < std::min(most, ranking.size()); ++k) best.push_back(planes[ranking[k].second]);
  return best;
}

}  // namespace

std::vector<HalfSpace> promising_cuts(const geometry::TriangleMesh& piece, std::size_t most, int threads) {
  constexpr std::size_t k_rough = 150, k_fine = 600, k_kept = 16;  // edges, and planes between the two rounds
  constexpr double k_skin = 1e-6;                                  // share of the size
  const std::vector<SharedEdge> edges = shared_edges(piece);
  std::vector<HalfSpace> planes;
  add_even(piece, planes);
  add_hollow(hollow_edges(piece, edges), planes);
  const double skin = k_skin * geometry::box_of(piece).sizes().maxCoeff();
  if (edges.size() > k_rough) planes = best_of(planes, sample_edges(piece, edges, k_rough), skin, k_kept, threads);
  return best_of(planes, sample_edges(piece, edges, k_fine), skin, most, threads);
}

}  // namespace nilas::mesh
