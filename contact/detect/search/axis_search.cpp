#include "contact/detect/search/axis_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "contact/detect/surface/face_axes.h"
#include "core/base/order_free_sum.h"

namespace nilas::detect {

namespace {

/// Largest number of pairs of facing edges up to which all are combined at once (about 2 us).
constexpr std::size_t k_few_edge_pairs = 500;
/// Largest number of steps from one axis to a better one near it; two or three are enough.
constexpr int k_most_steps = 8;

class AxisSearch {
 public:
  AxisSearch(const PairView& pair, AxisSearchRoom& room, AxisSearchCounts& counts)
      : pair_(pair), room_(room), counts_(counts) {}

  Axis find(const RememberedAxis& remembered, FclShapes& fcl, bool ask_first) {
    if (try_remembered(remembered)) {
      ++counts_.kept;
      return best_;
    }
    if (!ask_first || remembered.kind == AxisKind::unnamed) {
      search(k_no_bound, fcl);
      ++counts_.searched;
      return best_;
    }
    const Axis first = ask_fcl(fcl);
    if (first.s > pair_.margin) {
      best_ = first;
      ++counts_.by_fcl;
      return best_;
    }
    const double near_face = best_face_near(first);
    search(near_face, fcl);
    const bool as_good = best_.s <= std::max(first.s, near_face) + pair_.tolerance;
    const bool same = first.s > k_no_bound && best_.n.dot(first.n) > k_same_direction;
    ++(as_good || same ? counts_.by_fcl : counts_.corrected);
    return best_;
  }

 private:
  static constexpr double k_no_bound = -std::numeric_limits<double>::infinity();

  /// The exact search; some face separates by at least `least` [m].
  void search(double least, FclShapes& fcl) {
    best_ = best_face_axis(pair_, pair_.margin, room_.rivals, least);
    if (settled() || try_shown_crossing() || try_facing_edges(k_few_edge_pairs)) return;
    if (follow_edges(best_) || follow_fcl(fcl)) return;
    try_facing_edges(k_most_edge_pairs);
  }

  /// Returns FCL's direction with the separation along it; k_no_bound without an answer.
  Axis ask_fcl(FclShapes& fcl) {
    Axis asked;
    ++counts_.fcl_queries;
    asked_ = true;
    if (const std::optional<Vec3> direction =
            fcl.direction(pair_, best_.s > k_no_bound ? best_.s > 0 : likely_apart(pair_))) {
      asked.n = *direction;
      asked.s = separation(pair_, asked.n);
      fcl_says_ = asked;
    } else {
      ++counts_.fallbacks;
    }
    return asked;
  }

  /// Returns the separation along the better of the two faces whose normals are nearest to a direction [m].
  double best_face_near(const Axis& direction) const {
    if (direction.s == k_no_bound) return k_no_bound;
    const auto nearest = [](const FacetedGeometry& facets, const Vec3& n) {
      Eigen::Index face = 0;
      (facets.normals.col(0) * n.x() + facets.normals.col(1) * n.y() + facets.normals.col(2) * n.z()).maxCoeff(&face);
      return static_cast<int>(face);
    };
    const Vec3 from_b = -(pair_.b_in_a.R.transpose() * direction.n);
    return std::max(face_axis(pair_, AxisKind::face_a, nearest(*pair_.a.facets, direction.n)).s,
                    face_axis(pair_, AxisKind::face_b, nearest(*pair_.b.facets, from_b)).s);
  }

  bool try_remembered(const RememberedAxis& remembered) {
    if (remembered.kind == AxisKind::direction || remembered.kind == AxisKind::unnamed) return false;
    if (remembered.kind == AxisKind::edges) {
      choose_two_edges(pair_, remembered.feature_a, remembered.feature_b, room_.edges);
      try_crossing_edges(pair_, room_.edges, room_.rivals, best_);
      if (best_.kind != AxisKind::edges) return false;
    } else {
      const bool of_a = remembered.kind == AxisKind::face_a;
      best_ = face_axis(pair_, remembered.kind, of_a ? remembered.feature_a : remembered.feature_b);
    }
    return settled();
  }

  /// Returns whether best_ separates by more than the margin or is proven. If it does not separate, lays the surfaces
  /// along it over each other.
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

  /// Tries the two edges that are seen to cross where the surfaces come nearest, as at a corner that stands out beyond
  /// the rim of a face. Most pairs that no face settles are of this kind.
  bool try_shown_crossing() {
    const OverlayPoint* nearest = nearest_shown();
    if (nearest == nullptr || nearest->feature.kind != FeatureKind::crossing) return false;
    choose_two_edges(pair_, nearest->feature.first, nearest->feature.second, room_.edges);
    Axis next = best_;
    try_crossing_edges(pair_, room_.edges, room_.rivals, next);
    if (next.s <= best_.s + pair_.tolerance) return false;
    best_ = next;
    return settled();
  }

  /// Returns the middle of the supporting vertices along n, in the part's frame.
  Vec3 support_middle(const Part& part, const Vec3& n) {
    support_vertices(*part.facets, n, pair_.tolerance, room_.vertices);
    OrderFreeVectorSum sum;
    for (const int v : room_.vertices) sum.add(part.facets->vertex(v));
    return sum.value() / static_cast<double>(room_.vertices.size());
  }

  /// Returns the points where the surfaces along best_ come nearest, or the middles of their supports when they have no
  /// common place.
  NearPoints near_points() {
    if (const OverlayPoint* p = nearest_shown()) {
      const ContactPlane& plane = room_.facing.plane;
      const Vec3 on_a = p->u * plane.t1 + p->v * plane.t2 + p->height_a * plane.n;
      return {on_a, on_a + p->gap * plane.n};
    }
    const Vec3 n_b = -(pair_.b_in_a.R.transpose() * best_.n);
    return {support_middle(pair_.a, best_.n), pair_.b_in_a.point(support_middle(pair_.b, n_b))};
  }

  /// Returns whether the pairs were few enough to try them all. Faces and edges together hold the best axis.
  bool try_facing_edges(std::size_t most_pairs) {
    const NearPoints near = near_points();
    choose_facing_edges(pair_, best_.s, near, room_.edges);
    if (room_.edges.of_a.size() * room_.edges.of_b.size() > most_pairs) return false;
    const Axis before = best_;
    try_crossing_edges(pair_, room_.edges, room_.rivals, best_);
    if (best_.s > -pair_.tolerance) {
      if (before.s <= -pair_.tolerance) choose_facing_edges(pair_, best_.s, near, room_.edges);
      try_nearest_edges(pair_, room_.edges, best_);
    }
    if (best_.n != before.n) settled();  // a tie may have changed the axis without a better s
    return true;
  }

  /// Tries edges near the support along `from`, from axis to axis as long as they improve.
  bool follow_edges(Axis from) {
    for (int step = 0; step < k_most_steps; ++step) {
      choose_edges_along(pair_, from.n, room_.edges);
      Axis next = from;
      try_crossing_edges(pair_, room_.edges, room_.rivals, next);
      if (next.s > -pair_.tolerance) try_nearest_edges(pair_, room_.edges, next);
      if (next.s <= from.s + pair_.tolerance) return false;
      from = next;
      if (from.s <= best_.s + pair_.tolerance) continue;
      best_ = from;
      if (settled()) return true;
    }
    return false;
  }

  bool follow_fcl(FclShapes& fcl) {
    if (!asked_) ask_fcl(fcl);
    if (!fcl_says_) return false;
    if (fcl_says_->s > best_.s + pair_.tolerance) {
      best_ = *fcl_says_;
      if (settled()) return true;
    }
    return follow_edges(*fcl_says_);
  }

  const PairView& pair_;
  AxisSearchRoom& room_;
  AxisSearchCounts& counts_;
  Axis best_;
  bool asked_ = false;
  std::optional<Axis> fcl_says_;
};

}  // namespace

Axis find_axis(const PairView& pair, const RememberedAxis& remembered, FclShapes& fcl, bool ask_first,
               AxisSearchRoom& room, AxisSearchCounts& counts) {
  return AxisSearch(pair, room, counts).find(remembered, fcl, ask_first);
}

}  // namespace nilas::detect
