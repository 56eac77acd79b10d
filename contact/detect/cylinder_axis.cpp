#include "contact/detect/cylinder_axis.h"

#include <cmath>

#include "contact/detect/face_axes.h"
#include "contact/detect/nearest_point.h"

namespace nilas {

namespace {

constexpr int k_most_steps = 6;

class CylinderSearch {
 public:
  CylinderSearch(const PairView& pair, AxisSearchRoom& room, AxisSearchCounts& counts)
      : pair_(pair), facing_(room.facing), counts_(counts) {}

  Axis find(FclShapes& fcl) {
    best_ = best_face_axis(pair_, pair_.margin);
    if (best_.s > pair_.margin) return best_;
    for (const Side& side : {side_a(), side_b()})
      if (is_round(side)) try_both_ways(side.in_a.R.col(2));
    if (is_round(side_a()) && is_round(side_b())) try_axes_of_both();
    try_both_ways(pair_.b_in_a.point(pair_.b.centre) - pair_.a.centre);
    improve();
    if (settled()) return best_;
    ask_fcl(fcl);
    settled();
    return best_;
  }

 private:
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

  /// From the best axis to exact ones near it.
  void improve() {
    for (int step = 0; step < k_most_steps; ++step) {
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

  void ask_fcl(FclShapes& fcl) {
    ++counts_.fcl_queries;
    const std::optional<Vec3> direction = fcl.direction(pair_, best_.s > 0);
    if (!direction) {
      ++counts_.fallbacks;
      return;
    }
    try_direction(*direction);
    improve();
  }

  const PairView& pair_;
  FacingSurfaces& facing_;
  AxisSearchCounts& counts_;
  const RelativePose own_frame_;
  Axis best_;
};

}  // namespace

Axis find_cylinder_axis(const PairView& pair, FclShapes& fcl, AxisSearchRoom& room, AxisSearchCounts& counts) {
  return CylinderSearch(pair, room, counts).find(fcl);
}

}  // namespace nilas
