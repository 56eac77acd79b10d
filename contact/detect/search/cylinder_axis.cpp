#include "contact/detect/search/cylinder_axis.h"

#include <limits>
#include <optional>
#include <vector>

#include "contact/detect/search/two_cylinders.h"
#include "contact/detect/surface/face_axes.h"
#include "contact/detect/surface/nearest_point.h"

namespace nilas::detect {

namespace {

constexpr int k_most_cylinder_steps = 6;
constexpr double k_none = -std::numeric_limits<double>::infinity();

class CylinderSearch {
 public:
  CylinderSearch(const PairView& pair, AxisSearchRoom& room, AxisSearchCounts& counts)
      : pair_(pair), room_(room), facing_(room.facing), counts_(counts) {}

  Axis find(const RememberedAxis& remembered, FclShapes& fcl, bool ask_first) {
    if (!ask_first || remembered.kind == AxisKind::unnamed) {
      search(fcl);
      ++counts_.searched;
      return best_;
    }
    ask_fcl(fcl);
    if (fcl_says_ && fcl_says_->s > pair_.margin) {
      best_ = *fcl_says_;
      ++counts_.by_fcl;
      return best_;
    }
    search(fcl);
    const bool same =
        fcl_says_ && (best_.s <= fcl_says_->s + pair_.tolerance || best_.n.dot(fcl_says_->n) > k_same_direction);
    ++(same ? counts_.by_fcl : counts_.corrected);
    return best_;
  }

 private:
  void search(FclShapes& fcl) {
    best_ = best_face_axis(pair_, pair_.margin, room_.rivals);
    if (best_.s > pair_.margin) return;
    for (const Side& side : {side_a(), side_b()})
      if (is_round(side)) try_both_ways(side.in_a.R.col(2));
    if (is_round(side_a()) && is_round(side_b())) try_axes_of_both();
    try_both_ways(pair_.b_in_a.point(pair_.b.centre) - pair_.a.centre);
    improve();
    if (settled()) return;
    try_all_round_axes();
    improve();
    if (settled() || best_.s <= 0) return;
    if (!asked_) ask_fcl(fcl);
    if (!fcl_says_) return;
    try_direction(fcl_says_->n);
    improve();
    settled();
  }

  void ask_fcl(FclShapes& fcl) {
    ++counts_.fcl_queries;
    asked_ = true;
    const std::optional<Vec3> direction = fcl.direction(pair_, best_.s > k_none ? best_.s > 0 : likely_apart(pair_));
    if (!direction) {
      ++counts_.fallbacks;
      return;
    }
    fcl_says_ = Axis{*direction, separation(pair_, *direction)};
  }

  struct Side {
    const Part& part;
    const RelativePose& in_a;
    double sign;
  };
  Side side_a() const { return {pair_.a, own_frame_, 1.0}; }
  Side side_b() const { return {pair_.b, pair_.b_in_a, -1.0}; }
  static bool is_round(const Side& side) { return side.part.kind == PartKind::cylinder; }

  bool settled() {
    if (best_.s > pair_.margin) return true;
    face_each_other(pair_, best_, facing_);
    return is_proven(pair_, best_, facing_);
  }

  void try_direction(const Vec3& direction) {
    const double length = direction.norm();
    if (!(length > pair_.tolerance)) return;
    const Vec3 n = direction / length;
    const double s = separation(pair_, n);
    if (s > best_.s + pair_.tolerance) best_ = {n, s, AxisKind::direction, -1, -1};
  }

  void try_both_ways(const Vec3& direction) {
    try_direction(direction);
    try_direction(-direction);
  }

  void try_axes_of_both() {
    const Vec3 axis_a = Vec3::UnitZ();
    const Vec3 axis_b = pair_.b_in_a.R.col(2);
    try_both_ways(axis_a.cross(axis_b));
    const Vec3 between = pair_.b_in_a.p;
    try_both_ways(between - between.dot(axis_a) * axis_a);
    try_both_ways(between - between.dot(axis_b) * axis_b);
  }

  // Parts overlap least along the normal of a smooth place on their Minkowski difference [regular points, Schneider
  // 2013, Convex Bodies, 2.2]: a face, a cap, an edge or side that crosses a side, a vertex beside a side, a rim along
  // an edge, or two rims. The first three have single directions, the others are searched place by place.

  void try_all_round_axes() {
    if (is_round(side_a()) && is_round(side_b())) {
      try_rim_along_side(side_a(), side_b());
      try_rim_along_side(side_b(), side_a());
      try_rims();
    } else if (is_round(side_a())) {
      try_edges_and_vertices(side_b(), side_a());
    } else {
      try_edges_and_vertices(side_a(), side_b());
    }
  }

  static RoundBody round_body(const Part& part, const RelativePose& pose) {
    return {pose.point(part.centre), pose.R.col(2), part.radius, part.half_height};
  }

  /// Tries the edges and vertices of `polytope` against `round`, in the polytope's frame and along the polytope's
  /// outward directions.
  void try_edges_and_vertices(const Side& polytope, const Side& round) {
    const FacetedGeometry& facets = *polytope.part.facets;
    const RelativePose to_own = polytope.in_a.inverse();
    const RoundBody body = round_body(round.part, {to_own.R * round.in_a.R, to_own.point(round.in_a.p)});
    const auto offer = [&](const Vec3& n) { try_direction(polytope.sign * (polytope.in_a.R * n)); };
    const auto try_square_to_axis = [&](const Vec3& vertex, const Vec3& direction) {
      const double length = direction.norm();
      const Vec3 n = direction / length;
      if (length > pair_.tolerance && n.dot(body.centre - vertex) - body.radius > best_.s) offer(n);
    };
    for (const Vec3& v : facets.polytope->vertices) {
      const Vec3 out = body.centre - v;
      const Vec3 across = out - out.dot(body.axis) * body.axis;
      try_square_to_axis(v, across);
      try_square_to_axis(v, -across);
    }
    for (const PartEdge& edge : facets.edges) {
      const Vec3& v = facets.polytope->vertices[edge.v0];
      const Vec3 crossing = facets.along(edge).cross(body.axis);
      try_square_to_axis(v, crossing);
      try_square_to_axis(v, -crossing);
      const Arc arc = arc_between(facets.polytope->normals[edge.f0], facets.polytope->normals[edge.f1]);
      if (most_over_arc(arc, v, round.part.inner_radius, body) <= best_.s) continue;
      const RoundAxis best = best_over_arc(arc, v, body);
      if (best.s > best_.s) offer(best.n);
    }
  }

  /// Tries the rims of `round` along the side of `straight`. That side is an edge around which directions turn fully.
  void try_rim_along_side(const Side& straight, const Side& round) {
    const RoundBody line = round_body(straight.part, straight.in_a), body = round_body(round.part, round.in_a);
    const Vec3 start = line.axis.unitOrthogonal();
    for (const double sign : {1.0, -1.0}) {
      const Arc half_turn{sign * start, sign * line.axis.cross(start), k_pi};
      try_direction(straight.sign * best_over_arc(half_turn, line.centre, body).n);
    }
  }

  void try_rims() {
    const RoundBody a = round_body(pair_.a, own_frame_), b = round_body(pair_.b, pair_.b_in_a);
    const RoundAxis best = best_of_all_directions(a, b, {best_.n, best_.s}, pair_.tolerance);
    try_direction(climb_between_rims(a, b, best.n).n);
  }

  /// Steps from the best axis to exact ones near it.
  void improve() {
    for (int step = 0; step < k_most_cylinder_steps; ++step) {
      const double before = best_.s;
      improve_between(side_a(), side_b());
      improve_between(side_b(), side_a());
      if (best_.s <= before + pair_.tolerance) return;
    }
  }

  void improve_between(const Side& round, const Side& other) {
    if (!is_round(round)) return;
    const Vec3 n = best_.n;
    const Vec3 axis = round.in_a.R.col(2);
    try_direction(n - n.dot(axis) * axis);
    if (!other.part.facets) return;
    const FacetedGeometry& facets = *other.part.facets;
    std::vector<int> vertices;
    support_vertices(facets, other.in_a.R.transpose() * (other.sign * n), pair_.tolerance, vertices);
    const RelativePose to_round = round.in_a.inverse();
    for (int v : vertices) {
      const Vec3 x = to_round.point(other.in_a.point(facets.polytope->vertices[v]));
      try_direction(round.sign * (round.in_a.R * nearest_point(round.part, x).normal));
      for (int w : facets.polytope->vertex_neighbours[v]) {
        const Vec3 edge = (other.in_a.R * (facets.polytope->vertices[w] - facets.polytope->vertices[v])).normalized();
        try_direction(n - n.dot(edge) * edge);
        try_both_ways(axis.cross(edge));
      }
    }
  }

  const PairView& pair_;
  AxisSearchRoom& room_;
  FacingSurfaces& facing_;
  AxisSearchCounts& counts_;
  const RelativePose own_frame_;
  Axis best_;
  bool asked_ = false;
  std::optional<Axis> fcl_says_;
};

}  // namespace

Axis find_cylinder_axis(const PairView& pair, const RememberedAxis& remembered, FclShapes& fcl, bool ask_first,
                        AxisSearchRoom& room, AxisSearchCounts& counts) {
  return CylinderSearch(pair, room, counts).find(remembered, fcl, ask_first);
}

}  // namespace nilas::detect
