#include "contact/detect/search/way_out.h"

#include <algorithm>
#include <limits>

#include "contact/detect/search/cover_cut.h"
#include "contact/detect/surface/axis_choice.h"
#include "contact/detect/surface/face_axes.h"
#include "core/base/order_free_sum.h"

namespace nilas::detect {

namespace {

/// Number of the axes with the largest separation that are tried.
constexpr int k_most_tries = 64;

/// An axis of crossing edges gives way to an exit shorter than this share of its depth. Along the normals of the faces
/// at a right-angled edge, a crossing leaves by 0.7 of the depth or more.
constexpr double k_much_shorter = 0.2;

class WayOut {
 public:
  WayOut(const PairView& pair, AxisSearchRoom& room, bool apart, bool alone)
      : pair_(pair), room_(room), apart_(apart), alone_(alone) {
    for (const bool of_a : {true, false})
      if ((of_a ? pair.a : pair.b).cover) sides_.push_back({pair, of_a});
  }

  /// Removes from room_.facing, which has the surfaces along the axis, the points that the whole bodies do not show.
  /// Returns whether the axis serves.
  bool serves(const Axis& axis) {
    bool own_face = false;
    for (const CoveredSide& side : sides_) {
      if (side.owns(axis.kind)) {
        own_face = true;
        if (side.cover().face_is_internal[face_of(axis)] != 0) return false;
      } else if (!shows_support(side, axis)) {
        return false;
      }
    }
    // an axis that is not the two parts' best is known to be there only where the surfaces show it
    if (searching_ && !own_face && room_.facing.smallest_gap > axis.s + pair_.tolerance) return false;
    const std::size_t shown = room_.facing.points.size();
    for (const CoveredSide& side : sides_) {
      cut_covered(side, axis, room_.facing);
      if (apart_) drop_overlaps(side);
      if (side.owns(axis.kind)) drop_dominated(side, room_.facing);
    }
    if (room_.facing.points.empty() && (own_face || shown > 0)) return false;
    if (searching_ && !alone_ && offers_nearer_way(axis)) return false;
    for (const CoveredSide& side : sides_) drop_internal_features(side, room_.facing);
    // the place that has the depth of the axis is then none of this pair's
    if ((own_face && searching_) || room_.facing.points.size() < shown)
      room_.facing.smallest_gap = -std::numeric_limits<double>::infinity();
    return true;
  }

  bool search(Axis& axis) {
    searching_ = true;
    std::vector<Axis> candidates;
    add_faces(candidates);
    Axis best;
    const bool found = try_best_first(candidates, best);
    candidates.clear();
    add_crossings(best.s + pair_.tolerance, candidates);
    Axis crossing;
    const bool crosses = try_best_first(candidates, crossing);
    if (!found && !crosses) return false;
    if (!crosses) {
      lay(best);
      serves(best);
    }
    axis = crosses ? crossing : best;
    return true;
  }

 private:
  static std::size_t face_of(const Axis& axis) {
    return static_cast<std::size_t>(axis.kind == AxisKind::face_a ? axis.feature_a : axis.feature_b);
  }
  void lay(const Axis& axis) { face_each_other(pair_, axis, room_.facing); }

  /// Returns whether the part reaches the support along the axis at a place of the whole body's surface.
  bool shows_support(const CoveredSide& side, const Axis& axis) {
    const Vec3 n = side.outward(axis.n);
    bool seen = false;
    for (const OverlayPoint& p : room_.facing.points) {
      if (p.gap > axis.s + pair_.tolerance) continue;
      seen = true;
      if (!side.cover().hides(side.place(room_.facing.plane, p), n)) return true;
    }
    if (seen) return false;
    const FacetedGeometry& facets = *side.part().facets;
    support_vertices(facets, n, pair_.tolerance, room_.vertices);
    return std::any_of(room_.vertices.begin(), room_.vertices.end(),
                       [&](int v) { return !side.cover().hides(facets.polytope->vertices[v], n); });
  }

  /// Parts that do not overlap have no points that do.
  void drop_overlaps(const CoveredSide& side) {
    const double least = -side.cover().tolerance;
    std::erase_if(room_.facing.points, [&](const OverlayPoint& p) { return p.gap < least; });
  }

  static bool leads_out_within(double depth, const Part& part, const Vec3& x) {
    const geometry::ConvexPolytope& polytope = *part.facets->polytope;
    for (std::size_t f = 0; f < polytope.normals.size(); ++f) {
      const Vec3& n = polytope.normals[f];
      const double distance = polytope.offsets[f] - n.dot(x);
      if (distance < depth && !(part.cover && part.cover->hides(x + distance * n, n))) return true;
    }
    return false;
  }

  /// Returns whether the middle of the contact could leave the part that owns the face by a shorter path than the axis.
  /// For crossing edges: either part by a much shorter one.
  bool offers_nearer_way(const Axis& axis) const {
    OrderFreeVectorSum on_a, on_b;
    OrderFreeSum gaps;
    const CoveredSide of_a{pair_, true}, of_b{pair_, false};
    for (const OverlayPoint& p : room_.facing.points) {
      on_a.add(of_a.place(room_.facing.plane, p));
      on_b.add(of_b.place(room_.facing.plane, p));
      gaps.add(p.gap);
    }
    const auto count = static_cast<double>(room_.facing.points.size());
    const double depth = -gaps.value() / count - sides_.front().cover().tolerance;
    if (depth <= 0) return false;
    const double within = axis.kind == AxisKind::edges ? k_much_shorter * depth : depth;
    return (axis.kind != AxisKind::face_b &&
            leads_out_within(within, pair_.a, pair_.b_in_a.point(on_b.value() / count))) ||
           (axis.kind != AxisKind::face_a &&
            leads_out_within(within, pair_.b, pair_.a_in_b.point(on_a.value() / count)));
  }

  void add_faces(std::vector<Axis>& out) const {
    for (const AxisKind kind : {AxisKind::face_a, AxisKind::face_b}) {
      const Part& part = kind == AxisKind::face_a ? pair_.a : pair_.b;
      if (!part.facets) continue;
      const int count = static_cast<int>(part.facets->polytope->faces.size());
      for (int f = 0; f < count; ++f)
        if (!part.cover || part.cover->face_is_internal[f] == 0) out.push_back(face_axis(pair_, kind, f));
    }
  }

  void add_crossings(double least, std::vector<Axis>& out) {
    if (!pair_.a.facets || !pair_.b.facets) return;
    choose_facing_edges(pair_, least, {pair_.a.centre, pair_.b_in_a.point(pair_.b.centre)}, room_.edges);
    const auto drop_internal = [](const Part& part, std::vector<EdgeInA>& edges) {
      if (!part.cover) return;
      std::erase_if(edges, [&](const EdgeInA& edge) { return part.cover->edge_is_internal[edge.edge] != 0; });
    };
    drop_internal(pair_.a, room_.edges.of_a);
    drop_internal(pair_.b, room_.edges.of_b);
    if (room_.edges.of_a.size() * room_.edges.of_b.size() > k_most_edge_pairs) return;
    list_crossing_edges(room_.edges, least, out);
  }

  bool try_best_first(std::vector<Axis>& candidates, Axis& found) {
    for (int tries = 0; tries < k_most_tries && !candidates.empty(); ++tries) {
      AxisContest contest(pair_, room_.rivals);
      for (const Axis& candidate : candidates) contest.enter(candidate);
      const Axis axis = contest.winner();
      std::erase_if(candidates, [&](const Axis& other) {
        return other.n == axis.n && other.kind == axis.kind && other.feature_a == axis.feature_a &&
               other.feature_b == axis.feature_b;
      });
      lay(axis);
      if (!serves(axis)) continue;
      found = axis;
      return true;
    }
    return false;
  }

  const PairView& pair_;
  AxisSearchRoom& room_;
  bool apart_, alone_;
  bool searching_ = false;  ///< the axis that is tried need not be the best of the two parts by themselves
  std::vector<CoveredSide> sides_;
};

}  // namespace

bool find_way_out(const PairView& pair, AxisSearchRoom& room, Axis& axis, bool alone) {
  WayOut way(pair, room, axis.s >= -pair.tolerance, alone);
  if (way.serves(axis)) return true;
  axis.proven = false;
  return way.search(axis);
}

}  // namespace nilas::detect
