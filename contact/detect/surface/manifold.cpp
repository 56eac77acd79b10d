#include "contact/detect/surface/manifold.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "contact/detect/surface/edge_axes.h"
#include "contact/detect/surface/point_reduction.h"

namespace nilas::detect {

namespace {

/// Tolerance within which two loops are equally in front [cosine]. A's loop is then the window, so that names of points
/// do not change with rounding.
constexpr double k_same_alignment = 1e-6;

void lay_over(const SurfaceLoop& a, const SurfaceLoop& b, double tolerance, FacingSurfaces& facing) {
  constexpr std::size_t k_least_window = 3;
  const bool a_can = a.corners.size() >= k_least_window;
  const bool b_can = b.corners.size() >= k_least_window;
  if (!a_can && !b_can) return;
  const bool a_is_window = a_can && (!b_can || a.alignment >= b.alignment - k_same_alignment);
  clip(a, b, a_is_window, tolerance, facing.buffers, facing.points);
  facing.loop_ends.push_back(static_cast<int>(facing.points.size()));
}

/// Supporting edges whose directions differ by less than this sine meet along a length, not at a crossing [-].
constexpr double k_along_edges_sine = 1e-6;

/// Keeps once, and as the lower one, each point that two neighbouring faces share. On the seam itself it gets the mean
/// of both slopes. Equal gaps are put in an order that a mirrored pair shares.
void drop_repeated(double tolerance, std::vector<OverlayPoint>& points) {
  std::sort(points.begin(), points.end(), [](const OverlayPoint& p, const OverlayPoint& q) {
    if (p.feature != q.feature) return p.feature < q.feature;
    return std::tuple(p.gap, p.slope.u, std::abs(p.slope.v)) < std::tuple(q.gap, q.slope.u, std::abs(q.slope.v));
  });
  auto kept = points.begin();
  for (auto first = points.begin(); first != points.end(); ++kept) {
    OverlayPoint point = *first;
    point.slope = {};
    double count = 0;
    const auto end = std::find_if(first, points.end(), [&](const auto& p) { return p.feature != point.feature; });
    for (; first != end; ++first) {
      if (first->gap > point.gap + tolerance) continue;
      point.slope.u += first->slope.u;
      point.slope.v += first->slope.v;
      count += 1;
    }
    point.slope.u /= count;
    point.slope.v /= count;
    *kept = point;
  }
  points.erase(kept, points.end());
}

/// Supporting vertices of one side in the contact plane.
struct SupportSet {
  std::vector<LoopCorner> corners;
  double height = 0;
  bool is_cap = false;  ///< the one corner is the centre of a cylinder's cap
};

SupportSet support_set(const PatchView& view, const ContactPlane& plane, double tolerance) {
  SupportSet set;
  const Vec3 direction = view.in_a.R.transpose() * (view.sign * plane.n);
  const auto add = [&](const Vec3& local, int name) {
    const Vec3 x = view.in_a.point(local);
    set.corners.push_back({plane.t1.dot(x), plane.t2.dot(x), name, -1});
    const double height = plane.n.dot(x);
    set.height = set.corners.size() == 1 || view.sign * height > view.sign * set.height ? height : set.height;
  };
  if (view.part.facets) {
    std::vector<int> vertices;
    support_vertices(*view.part.facets, direction, tolerance, vertices);
    for (int v : vertices) add(view.part.facets->vertex(v), v);
  } else {
    const CylinderSupport support = cylinder_support(view.part, direction, tolerance);
    for (int i = 0; i < support.count; ++i) add(support.points[i], i);
    set.is_cap = support.points[0].head<2>().isZero(0);
  }
  return set;
}

Vec3 in_plane(const LoopCorner& c) { return {c.u, c.v, 0}; }

/// Returns the vertex nearest to where the features meet, whatever the order of indices in its part. A corner that met
/// alone then keeps its name when the edge next to it joins, and so does its image. Near the middle it is the lower
/// index.
int name_of(const SupportSet& set, const Vec3& meeting) {
  constexpr double k_middle_share = 1e-3;  // of the distance
  const LoopCorner* nearest = &set.corners.front();
  const auto distance = [&](const LoopCorner& c) { return (in_plane(c) - meeting).head<2>().norm(); };
  for (const LoopCorner& c : set.corners) {
    const double difference = distance(c) - distance(*nearest);
    const bool as_near = std::abs(difference) <= k_middle_share * distance(*nearest);
    if (as_near ? c.vertex < nearest->vertex : difference < 0) nearest = &c;
  }
  return nearest->vertex;
}

/// Returns the middle of the overlap of q's segment with p's, as a place along p's [-].
double middle_of_overlap(const Vec3& p, const Vec3& along_p, const Vec3& q, const Vec3& along_q) {
  const double scale = along_p.squaredNorm();
  const double first = along_p.dot(q - p) / scale;
  const double last = along_p.dot(q + along_q - p) / scale;
  return 0.5 * (std::clamp(first, 0.0, 1.0) + std::clamp(last, 0.0, 1.0));
}

/// Reduces a chain of vertices along one line to its two ends. All corners are put in an order that a mirrored pair
/// shares.
void reduce_to_ends(SupportSet& set, double tolerance) {
  std::sort(set.corners.begin(), set.corners.end(), [](const LoopCorner& p, const LoopCorner& q) {
    return std::tuple(p.u, std::abs(p.v), p.v) < std::tuple(q.u, std::abs(q.v), q.v);
  });
  if (set.corners.size() <= 2) return;
  const auto farthest_from = [&](const LoopCorner& from) {
    return *std::max_element(set.corners.begin(), set.corners.end(), [&](const LoopCorner& p, const LoopCorner& q) {
      return (in_plane(p) - in_plane(from)).squaredNorm() < (in_plane(q) - in_plane(from)).squaredNorm();
    });
  };
  const LoopCorner first = farthest_from(set.corners.front()), last = farthest_from(first);
  const Vec3 along = (in_plane(last) - in_plane(first)).normalized();
  for (const LoopCorner& c : set.corners)
    if (along.cross(in_plane(c) - in_plane(first)).norm() > tolerance) return;
  set.corners = {first, last};
}

/// Returns where a vertex or an edge touches a cap: its point nearest to the cap's centre.
Vec3 point_on_cap(const LoopCorner& centre, const SupportSet& set) {
  const Vec3 p = in_plane(set.corners.front()), along = in_plane(set.corners.back()) - p;
  if (along.isZero(0)) return p;
  return p + std::clamp(along.dot(in_plane(centre) - p) / along.squaredNorm(), 0.0, 1.0) * along;
}

/// Returns where two supporting features (vertex, edge or more) meet in the contact plane.
Vec3 meeting_point(const SupportSet& a, const SupportSet& b) {
  if (a.is_cap != b.is_cap) return a.is_cap ? point_on_cap(a.corners[0], b) : point_on_cap(b.corners[0], a);
  if (a.corners.size() == 2 && b.corners.size() == 2) {
    const Vec3 p = in_plane(a.corners[0]), q = in_plane(b.corners[0]);
    const Vec3 along_p = in_plane(a.corners[1]) - p, along_q = in_plane(b.corners[1]) - q;
    const double across = along_p.x() * along_q.y() - along_p.y() * along_q.x();
    if (std::abs(across) <= k_along_edges_sine * along_p.norm() * along_q.norm())
      return p + middle_of_overlap(p, along_p, q, along_q) * along_p;
    const NearestOnSegments nearest = nearest_on_segments(p, along_p, q, along_q);
    return 0.5 * (p + nearest.t * along_p + q + nearest.u * along_q);
  }
  const SupportSet& smaller = b.corners.size() < a.corners.size() ? b : a;
  Vec3 sum = Vec3::Zero();
  for (const LoopCorner& c : smaller.corners) sum += in_plane(c);
  return sum / static_cast<double>(smaller.corners.size());
}

}  // namespace

void face_each_other(const PairView& pair, const Axis& axis, FacingSurfaces& facing) {
  static const RelativePose k_own_frame;
  const int face_a = axis.kind == AxisKind::face_a ? axis.feature_a : -1;
  const int face_b = axis.kind == AxisKind::face_b ? axis.feature_b : -1;
  facing.plane = contact_plane(axis.n);
  const double slack = pair.margin - axis.s;
  const Vec3 a_in_b = pair.a_in_b.point(pair.a.centre), b_in_a = pair.b_in_a.point(pair.b.centre);
  show_surface({pair.a, k_own_frame, 1.0, face_a, slack, b_in_a, pair.b.bounding_radius}, facing.plane, pair.tolerance,
               facing.a);
  show_surface({pair.b, pair.b_in_a, -1.0, face_b, slack, a_in_b, pair.a.bounding_radius}, facing.plane, pair.tolerance,
               facing.b);
  facing.points.clear();
  facing.loop_ends.clear();
  for (int i = 0; i < facing.a.size(); ++i)
    for (int j = 0; j < facing.b.size(); ++j) lay_over(facing.a[i], facing.b[j], pair.tolerance, facing);
  facing.smallest_gap = std::numeric_limits<double>::infinity();
  for (const OverlayPoint& p : facing.points) facing.smallest_gap = std::min(facing.smallest_gap, p.gap);
}

std::size_t select_points(const PairView& pair, const Axis& axis, std::span<const Feature> last,
                          FacingSurfaces& facing) {
  auto& points = facing.points;
  const bool one_face_each = facing.a.size() * facing.b.size() == 1 && pair.a.facets && pair.b.facets;
  facing.curved = facing.a.size() * facing.b.size() > 1;
  if (!one_face_each) drop_repeated(pair.tolerance, points);
  points.erase(
      std::remove_if(points.begin(), points.end(), [&](const OverlayPoint& p) { return !(p.gap < pair.margin); }),
      points.end());
  if (!(facing.smallest_gap <= axis.s + pair.tolerance) && axis.s < pair.margin) {
    static const RelativePose k_own_frame;
    SupportSet a = support_set({pair.a, k_own_frame, 1.0}, facing.plane, pair.tolerance);
    SupportSet b = support_set({pair.b, pair.b_in_a, -1.0}, facing.plane, pair.tolerance);
    reduce_to_ends(a, pair.tolerance);
    reduce_to_ends(b, pair.tolerance);
    const Vec3 p = meeting_point(a, b);
    const Feature feature{FeatureKind::support_sets, name_of(a, p), name_of(b, p)};
    points.push_back({p.x(), p.y(), feature, a.height, axis.s});
  }
  const double cover =
      !facing.curved ? k_four_points_do : k_cover_share * std::min(pair.a.inner_radius, pair.b.inner_radius);
  return keep_spread_points(pair.tolerance, pair.margin, cover, points, last);
}

}  // namespace nilas::detect
