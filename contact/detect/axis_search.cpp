#include "contact/detect/axis_search.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "contact/detect/face_axes.h"
#include "core/base/order_free_sum.h"

namespace nilas {

namespace {

/// All edges that face each other are combined while there are at most so many pairs (about 2 us).
constexpr std::size_t k_few_edge_pairs = 500;
/// The same as a last resort (about 100 us).
constexpr std::size_t k_most_edge_pairs = 20000;
/// Steps from one axis to a better one near it; two or three do.
constexpr int k_most_steps = 8;

class AxisSearch {
 public:
  AxisSearch(const PairView& pair, AxisSearchRoom& room, AxisSearchCounts& counts)
      : pair_(pair), room_(room), counts_(counts) {}

  Axis find(const RememberedAxis& remembered, FclShapes& fcl) {
    if (try_remembered(remembered)) {
      ++counts_.kept;
      return best_;
    }
    best_ = best_face_axis(pair_, pair_.margin);
    if (settled() || try_shown_crossing() || try_facing_edges(k_few_edge_pairs)) return best_;
    if (follow_edges(best_) || ask_fcl(fcl)) return best_;
    try_facing_edges(k_most_edge_pairs);
    return best_;
  }

 private:
  bool try_remembered(const RememberedAxis& remembered) {
    if (remembered.kind == AxisKind::direction) return false;
    if (remembered.kind == AxisKind::edges) {
      choose_two_edges(pair_, remembered.feature_a, remembered.feature_b, room_.edges);
      try_crossing_edges(pair_, room_.edges, best_);
      if (best_.kind != AxisKind::edges) return false;
    } else {
      const bool of_a = remembered.kind == AxisKind::face_a;
      best_ = face_axis(pair_, remembered.kind, of_a ? remembered.feature_a : remembered.feature_b);
    }
    return settled();
  }

  /// True when best_ separates by more than the margin or is proven; lays the surfaces along it otherwise.
  bool settled() {
    if (best_.s > pair_.margin) return true;
    face_each_other(pair_, best_, room_.facing);
    best_.proven = is_proven(pair_, best_, room_.facing);
    return best_.proven;
  }

  const OverlayPoint* nearest_shown() const {
    const auto& points = room_.facing.points;
    // equal gaps in an order that a mirrored pair shares
    const auto nearer = [](const OverlayPoint& p, const OverlayPoint& q) {
      return std::tuple(p.gap, p.u, std::abs(p.v)) < std::tuple(q.gap, q.u, std::abs(q.v));
    };
    return points.empty() ? nullptr : &*std::min_element(points.begin(), points.end(), nearer);
  }

  /// A corner that stands out beyond the rim of a face: the edges seen to cross where the surfaces come nearest give
  /// the axis at once. Most pairs that no face settles are of this kind.
  bool try_shown_crossing() {
    const OverlayPoint* nearest = nearest_shown();
    if (nearest == nullptr || nearest->feature.kind != FeatureKind::crossing) return false;
    choose_two_edges(pair_, nearest->feature.first, nearest->feature.second, room_.edges);
    Axis next = best_;
    try_crossing_edges(pair_, room_.edges, next);
    if (next.s <= best_.s + pair_.tolerance) return false;
    best_ = next;
    return settled();
  }

  /// Middle of the supporting vertices along n, in the part's frame.
  Vec3 support_middle(const Part& part, const Vec3& n) {
    support_vertices(*part.facets, n, pair_.tolerance, room_.vertices);
    OrderFreeVectorSum sum;
    for (const int v : room_.vertices) sum.add(part.facets->polytope->vertices[v]);
    return sum.value() / static_cast<double>(room_.vertices.size());
  }

  /// Where the surfaces along best_ come nearest, or the middles of their supports when they show no common place.
  NearPoints near_points() {
    if (const OverlayPoint* p = nearest_shown()) {
      const ContactPlane& plane = room_.facing.plane;
      const Vec3 on_a = p->u * plane.t1 + p->v * plane.t2 + p->height_a * plane.n;
      return {on_a, on_a + p->gap * plane.n};
    }
    const Vec3 n_b = -(pair_.b_in_a.R.transpose() * best_.n);
    return {support_middle(pair_.a, best_.n), pair_.b_in_a.point(support_middle(pair_.b, n_b))};
  }

  /// True when there were few enough to try them all: faces and edges together hold the best axis.
  bool try_facing_edges(std::size_t most_pairs) {
    const NearPoints near = near_points();
    choose_facing_edges(pair_, best_.s, near, room_.edges);
    if (room_.edges.of_a.size() * room_.edges.of_b.size() > most_pairs) return false;
    const Axis before = best_;
    try_crossing_edges(pair_, room_.edges, best_);
    if (best_.s > -pair_.tolerance) {
      if (before.s <= -pair_.tolerance) choose_facing_edges(pair_, best_.s, near, room_.edges);
      try_nearest_edges(pair_, room_.edges, best_);
    }
    if (best_.n != before.n) settled();  // a tie may have changed the axis without a better s
    return true;
  }

  /// Edges near the support along `from`, from axis to axis as long as they improve.
  bool follow_edges(Axis from) {
    for (int step = 0; step < k_most_steps; ++step) {
      choose_edges_along(pair_, from.n, room_.edges);
      Axis next = from;
      try_crossing_edges(pair_, room_.edges, next);
      if (next.s > -pair_.tolerance) try_nearest_edges(pair_, room_.edges, next);
      if (next.s <= from.s + pair_.tolerance) return false;
      from = next;
      if (from.s <= best_.s + pair_.tolerance) continue;
      best_ = from;
      if (settled()) return true;
    }
    return false;
  }

  bool ask_fcl(FclShapes& fcl) {
    ++counts_.fcl_queries;
    const std::optional<Vec3> direction = fcl.direction(pair_, best_.s > 0);
    if (!direction) {
      ++counts_.fallbacks;
      return false;
    }
    Axis asked;
    asked.n = *direction;
    asked.s = separation(pair_, asked.n);
    if (asked.s > best_.s + pair_.tolerance) {
      best_ = asked;
      if (settled()) return true;
    }
    return follow_edges(asked);
  }

  const PairView& pair_;
  AxisSearchRoom& room_;
  AxisSearchCounts& counts_;
  Axis best_;
};

}  // namespace

Axis find_axis(const PairView& pair, const RememberedAxis& remembered, FclShapes& fcl, AxisSearchRoom& room,
               AxisSearchCounts& counts) {
  return AxisSearch(pair, room, counts).find(remembered, fcl);
}

}  // namespace nilas
