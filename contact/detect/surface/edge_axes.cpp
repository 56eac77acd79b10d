#include "contact/detect/surface/edge_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "contact/detect/surface/axis_choice.h"

namespace nilas::detect {

namespace {

/// Edges whose directions differ by less than this sine make no axis of their own [-], because rounding decides its
/// direction.
constexpr double k_parallel_sine = 1e-12;

EdgeInA own_edge(const FacetedGeometry& facets, int e) {
  const PartEdge& edge = facets.edges[e];
  const Vec3 n0 = facets.normal(edge.f0), n1 = facets.normal(edge.f1);
  return {e, facets.vertex(edge.v0), facets.along(edge), facets.middle(edge), n0, n1, n1.cross(n0)};
}

EdgeInA moved_edge(const FacetedGeometry& facets, int e, const RelativePose& pose) {
  const EdgeInA own = own_edge(facets, e);
  return {e,
          pose.point(own.start),
          pose.R * own.along,
          pose.point(own.middle),
          pose.R * own.n0,
          pose.R * own.n1,
          pose.R * own.arc};
}

struct OtherPart {
  Vec3 near, centre;  ///< points of it, in the frame of the part whose edges are chosen
  double inner_radius;
};

/// Chooses the edges of a part that face the other part; see choose_facing_edges. A point's heights over both faces of
/// an edge bound its separation along the directions between their normals. The bound is the larger height while
/// neither is above zero.
void facing_edges(const FacetedGeometry& facets, const OtherPart& other, double at_least, EdgeChoice& edges) {
  const auto heights_of = [&facets](const Vec3& p) {
    return facets.normals.col(0) * p.x() + facets.normals.col(1) * p.y() + facets.normals.col(2) * p.z() -
           facets.offsets;
  };
  const double least = std::min(0.0, at_least);
  const double least_of_centre = std::min(0.0, at_least + other.inner_radius);
  const bool only_crossings = at_least < 0;  // parts that overlap have no nearest points
  edges.heights = heights_of(other.near);
  if (only_crossings) edges.heights_of_centre = heights_of(other.centre);
  edges.chosen.clear();
  const auto higher = [](const Eigen::ArrayXd& heights, const PartEdge& edge) {
    return std::max(heights[edge.f0], heights[edge.f1]);
  };
  for (int e = 0; e < static_cast<int>(facets.edges.size()); ++e) {
    const PartEdge& edge = facets.edges[e];
    if (higher(edges.heights, edge) < least) continue;
    if (only_crossings && higher(edges.heights_of_centre, edge) < least_of_centre) continue;
    edges.chosen.push_back(e);
  }
}

void edges_at_support(const FacetedGeometry& facets, const Vec3& n, double tolerance, std::vector<int>& out) {
  std::vector<int> vertices;
  support_vertices(facets, n, tolerance, vertices);
  out.clear();
  int face = -1;
  for (int v : vertices) {
    out.insert(out.end(), facets.vertex_edges[v].begin(), facets.vertex_edges[v].end());
    for (int f : facets.vertex_faces[v])
      if (face < 0 || facets.normal(f).dot(n) > facets.normal(face).dot(n)) face = f;
  }
  if (face >= 0) out.insert(out.end(), facets.face_edges[face].begin(), facets.face_edges[face].end());
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

void take_edges_of_a(const PairView& pair, EdgeChoice& edges) {
  edges.of_a.clear();
  for (int e : edges.chosen) edges.of_a.push_back(own_edge(*pair.a.facets, e));
}

void take_edges_of_b(const PairView& pair, EdgeChoice& edges) {
  edges.of_b.clear();
  for (int e : edges.chosen) edges.of_b.push_back(moved_edge(*pair.b.facets, e, pair.b_in_a));
}

/// Returns whether some direction is outward for edge a of A and inward for edge b of B.
bool normal_arcs_cross(const EdgeInA& a, const EdgeInA& b) {
  const double b0 = b.n0.dot(a.arc), b1 = b.n1.dot(a.arc);
  if (b0 * b1 >= 0) return false;
  const double a0 = a.n0.dot(b.arc), a1 = a.n1.dot(b.arc);
  return a0 * a1 < 0 && -b0 * a1 > 0;
}

/// Calls use(a, b, n, s) for each pair of edges that makes an axis.
template <class Use>
void for_each_crossing(const EdgeChoice& edges, const Use& use) {
  for (const EdgeInA& a : edges.of_a)
    for (const EdgeInA& b : edges.of_b) {
      if (!normal_arcs_cross(a, b)) continue;
      Vec3 n = a.along.cross(b.along);
      const double length = n.norm();
      if (length <= k_parallel_sine * std::sqrt(a.along.squaredNorm() * b.along.squaredNorm())) continue;
      n /= n.dot(a.n0 + a.n1) < 0 ? -length : length;
      // the product of nearly parallel edges is rounded; about the edge it may be turned, along it the parts are long
      n = (n - n.dot(a.along) / a.along.squaredNorm() * a.along).normalized();
      use(a, b, n, n.dot(b.middle - a.middle));
    }
}

/// Returns the nearest points of p0 + t d0 and p1 + u d1, least <= t, u <= 1.
NearestOnSegments nearest_between(const Vec3& p0, const Vec3& d0, const Vec3& p1, const Vec3& d1, double least) {
  const Vec3 r = p0 - p1;
  const double a = d0.squaredNorm(), e = d1.squaredNorm();
  const double b = d0.dot(d1), c = d0.dot(r), f = d1.dot(r);
  // b f - c e over a e - b b, without their cancellation
  const Vec3 across = d0.cross(d1);
  const double denominator = across.squaredNorm();
  NearestOnSegments nearest;
  // Parallel segments: any t serves; the clamps below then find an end that lies opposite.
  if (denominator > k_parallel_sine * k_parallel_sine * a * e)
    nearest.t = std::clamp(across.dot(d1.cross(r)) / denominator, least, 1.0);
  nearest.u = std::clamp((b * nearest.t + f) / e, least, 1.0);
  nearest.t = std::clamp((b * nearest.u - c) / a, least, 1.0);
  return nearest;
}

}  // namespace

void choose_facing_edges(const PairView& pair, double at_least, const NearPoints& near, EdgeChoice& edges) {
  const double least = at_least - pair.tolerance;
  facing_edges(*pair.a.facets, {near.on_b, pair.b_in_a.point(pair.b.centre), pair.b.inner_radius}, least, edges);
  take_edges_of_a(pair, edges);
  facing_edges(*pair.b.facets, {pair.a_in_b.point(near.on_a), pair.a_in_b.point(pair.a.centre), pair.a.inner_radius},
               least, edges);
  take_edges_of_b(pair, edges);
}

void choose_edges_along(const PairView& pair, const Vec3& n, EdgeChoice& edges) {
  edges_at_support(*pair.a.facets, n, pair.tolerance, edges.chosen);
  take_edges_of_a(pair, edges);
  edges_at_support(*pair.b.facets, -(pair.b_in_a.R.transpose() * n), pair.tolerance, edges.chosen);
  take_edges_of_b(pair, edges);
}

void choose_two_edges(const PairView& pair, int edge_a, int edge_b, EdgeChoice& edges) {
  edges.chosen.assign(1, edge_a);
  take_edges_of_a(pair, edges);
  edges.chosen.assign(1, edge_b);
  take_edges_of_b(pair, edges);
}

void try_crossing_edges(const PairView& pair, const EdgeChoice& edges, std::vector<Axis>& room, Axis& best) {
  AxisContest contest(pair, room);
  contest.enter(best);
  for_each_crossing(edges, [&](const EdgeInA& a, const EdgeInA& b, const Vec3& n, double s) {
    contest.enter({n, s, AxisKind::edges, a.edge, b.edge});
  });
  best = contest.winner();
}

void list_crossing_edges(const EdgeChoice& edges, double least, std::vector<Axis>& out) {
  for_each_crossing(edges, [&](const EdgeInA& a, const EdgeInA& b, const Vec3& n, double s) {
    if (s > least) out.push_back({n, s, AxisKind::edges, a.edge, b.edge});
  });
}

void try_nearest_edges(const PairView& pair, const EdgeChoice& edges, Axis& best) {
  const Vec3 guide = best.n;
  constexpr double k_infinite = std::numeric_limits<double>::infinity();
  double distance = k_infinite;
  Vec3 shortest = Vec3::Zero();
  // Edges that meet in a vertex, or run alongside, are equally near: then what a mirrored pair shares decides. Places
  // on them count from their middles, since the image of an edge may run in the other direction.
  std::tuple<double, double, double, double> least{k_infinite, 0, 0, 0};
  for (const EdgeInA& a : edges.of_a) {
    const Vec3 half_a = 0.5 * a.along;
    const double high_a = guide.dot(a.middle) + std::abs(guide.dot(half_a));
    for (const EdgeInA& b : edges.of_b) {
      // Segments farther apart along the best axis so far than the nearest pair is are not nearer.
      const Vec3 half_b = 0.5 * b.along;
      if (guide.dot(b.middle) - std::abs(guide.dot(half_b)) - high_a >= distance + pair.tolerance) continue;
      const NearestOnSegments nearest = nearest_between(a.middle, half_a, b.middle, half_b, -1);
      const Vec3 between = b.middle - a.middle + (nearest.u * half_b - nearest.t * half_a);
      const double squared = between.squaredNorm();
      const std::tuple rank(squared, std::abs(between.x()), std::abs(between.y()), std::abs(between.z()));
      if (rank >= least) continue;
      least = rank;
      distance = std::sqrt(squared);
      shortest = between;
    }
  }
  if (!(distance > pair.tolerance)) return;
  const Vec3 n = shortest / distance;
  const double s = separation(pair, n);
  if (s > best.s + pair.tolerance) best = {n, s, AxisKind::direction, -1, -1};
}

NearestOnSegments nearest_on_segments(const Vec3& p0, const Vec3& d0, const Vec3& p1, const Vec3& d1) {
  return nearest_between(p0, d0, p1, d1, 0);
}

}  // namespace nilas::detect
