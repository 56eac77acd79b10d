#include "contact/detect/surface/overlay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace nilas::detect {

namespace {

using Corner = ClipBuffers::Corner;

double twice_area(const SurfaceLoop& loop) {
  double sum = 0;
  for (std::size_t k = 0; k < loop.corners.size(); ++k) {
    const LoopCorner& p = loop.corners[k];
    const LoopCorner& q = loop.corners[(k + 1) % loop.corners.size()];
    sum += p.u * q.v - p.v * q.u;
  }
  return sum;
}

/// One side of the window as a line; `sign` turns the inside to positive distances.
struct Side {
  double u, v;    ///< its middle, the same bits whichever end is listed first
  double du, dv;  ///< unit direction times sign
  double distance(double pu, double pv) const { return du * (pv - v) - dv * (pu - u); }
};

Side side_of(const SurfaceLoop& loop, std::size_t k, double sign) {
  const LoopCorner& p = loop.corners[k];
  const LoopCorner& q = loop.corners[(k + 1) % loop.corners.size()];
  const double du = q.u - p.u, dv = q.v - p.v;
  const double length = std::sqrt(du * du + dv * dv);
  const double scale = length > 0 ? sign / length : 0.0;
  return {0.5 * (p.u + q.u), 0.5 * (p.v + q.v), scale * du, scale * dv};
}

/// An order of the window's sides, around it, that a mirrored window shares. The order matters for points within the
/// tolerance of several sides.
class SideOrder {
 public:
  explicit SideOrder(const SurfaceLoop& window) : window_(window), count_(window.corners.size()) {
    for (std::size_t k = 1; k < count_; ++k)
      if (rank(k) < rank(first_)) first_ = k;
    step_ = rank((first_ + 1) % count_) < rank((first_ + count_ - 1) % count_) ? 1 : count_ - 1;
  }
  std::size_t operator[](std::size_t i) const { return (first_ + i * step_) % count_; }

 private:
  /// Returns the rank of a side by its middle. The images in u = 0 and v = 0 share the first two numbers.
  std::tuple<double, double, double, double> rank(std::size_t k) const {
    const LoopCorner& p = window_.corners[k];
    const LoopCorner& q = window_.corners[(k + 1) % count_];
    const double u = p.u + q.u, v = p.v + q.v;
    return {std::abs(u), std::abs(v), u, v};
  }

  const SurfaceLoop& window_;
  std::size_t count_, first_ = 0, step_ = 1;
};

/// Edges whose directions differ by less than this sine do not span a tangent plane [-].
constexpr double k_spanning_sine = 0.1;

/// Returns the slope of the plane through two crossing edges, one on each surface. For edges that run alongside it is
/// the mean of the surfaces' own slopes.
Slope crossing_slope(const SurfaceLoop& one, double du1, double dv1, const SurfaceLoop& other, double du2, double dv2) {
  const double area = du1 * dv2 - dv1 * du2;
  if (std::abs(area) <= k_spanning_sine * std::hypot(du1, dv1) * std::hypot(du2, dv2))
    return {0.5 * (one.hu + other.hu), 0.5 * (one.hv + other.hv)};
  const double rise1 = one.hu * du1 + one.hv * dv1, rise2 = other.hu * du2 + other.hv * dv2;
  return {(rise1 * dv2 - rise2 * dv1) / area, (rise2 * du1 - rise1 * du2) / area};
}

/// Makes points by cutting; A's features are named first.
struct Cutter {
  const SurfaceLoop& window;
  const SurfaceLoop& subject;
  bool a_is_window;

  /// Returns the point where the edge that begins at `from` leaves through a side of the window, whose line is `line`.
  Corner cut(const Corner& inner, const Corner& outer, const Corner& from, int side, const Side& line) const {
    if (from.side < 0) return crossing(from, side, line);
    // The edge lies on an earlier side of the window: the point is the window's corner between both.
    const int count = static_cast<int>(window.corners.size());
    if (from.side == (side + 1) % count) return corner_of_window(from.side);
    if (side == (from.side + 1) % count) return corner_of_window(side);
    Corner corner = between(inner.u, inner.v, inner.distance, outer.u, outer.v, outer.distance);
    corner.feature = {FeatureKind::window_sides, window.corners[from.side].edge, window.corners[side].edge};
    corner.slope = crossing_slope_of(side, outer.u - inner.u, outer.v - inner.v);
    return corner;
  }

 private:
  /// Returns the crossing of whole edges, not of what earlier sides left of them, so that it does not depend on the
  /// order of the sides.
  Corner crossing(const Corner& from, int side, const Side& line) const {
    const LoopCorner& p = subject.corners[from.place];
    const LoopCorner& q = subject.corners[(static_cast<std::size_t>(from.place) + 1) % subject.corners.size()];
    const double at_p = line.distance(p.u, p.v), at_q = line.distance(q.u, q.v);
    Corner corner = at_p > at_q ? between(p.u, p.v, at_p, q.u, q.v, at_q) : between(q.u, q.v, at_q, p.u, p.v, at_p);
    const int window_edge = window.corners[side].edge;
    corner.feature = a_is_window ? Feature{FeatureKind::crossing, window_edge, from.edge}
                                 : Feature{FeatureKind::crossing, from.edge, window_edge};
    corner.slope = crossing_slope_of(side, q.u - p.u, q.v - p.v);
    return corner;
  }

  /// Returns a corner of the window, which lies on the subject's face.
  Corner corner_of_window(int place) const {
    const LoopCorner& c = window.corners[place];
    const FeatureKind kind = a_is_window ? FeatureKind::vertex_a : FeatureKind::vertex_b;
    return {c.u, c.v, {kind, c.vertex, -1}, {subject.hu, subject.hv}};
  }

  Slope crossing_slope_of(int side, double du, double dv) const {
    const LoopCorner& p = window.corners[side];
    const LoopCorner& q = window.corners[(side + 1) % window.corners.size()];
    return crossing_slope(window, q.u - p.u, q.v - p.v, subject, du, dv);
  }

  /// Interpolates from the inner end to the outer one, whichever direction the loop has.
  static Corner between(double u_in, double v_in, double inside, double u_out, double v_out, double outside) {
    const double t = inside / (inside - outside);
    Corner corner;
    corner.u = u_in + t * (u_out - u_in);
    corner.v = v_in + t * (v_out - v_in);
    return corner;
  }
};

void cut_by_side(const Cutter& cutter, int side, const Side& line, double tolerance, const std::vector<Corner>& in,
                 std::vector<Corner>& out) {
  out.clear();
  for (std::size_t i = 0; i < in.size(); ++i) {
    const Corner& corner = in[i];
    const Corner& following = in[(i + 1) % in.size()];
    const bool leaves = following.distance < -tolerance;
    if (corner.distance >= -tolerance) {
      out.push_back(corner);
      if (leaves && corner.distance <= tolerance) out.back().side = side;
      if (!leaves || corner.distance <= tolerance) continue;
      out.push_back(cutter.cut(corner, following, corner, side, line));
      out.back().side = side;
    } else if (following.distance > tolerance) {
      out.push_back(cutter.cut(following, corner, corner, side, line));
      out.back().edge = corner.edge;
      out.back().place = corner.place;
      out.back().side = corner.side;
    }
  }
}

/// Keeps one of the corners that are closer than the tolerance, as an area thinner than that has them. A vertex goes
/// before a crossing; otherwise the first stays, in an order that a mirrored pair shares. The last in that order is
/// removed first, so the result does not depend on the direction of the loop.
void drop_coincident(double tolerance, std::vector<Corner>& corners) {
  const auto rank = [](const Corner& c) { return std::tuple(c.feature.kind, c.u, std::abs(c.v), c.v); };
  const auto meets_next = [&](std::size_t i) {
    const Corner &p = corners[i], &q = corners[(i + 1) % corners.size()];
    return std::abs(p.u - q.u) + std::abs(p.v - q.v) <= tolerance;
  };
  while (corners.size() > 1) {
    std::size_t last = corners.size();
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (meets_next(i))
        for (const std::size_t k : {i, (i + 1) % corners.size()})
          if (last == corners.size() || rank(corners[last]) < rank(corners[k])) last = k;
    if (last == corners.size()) return;
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(last));
  }
}

}  // namespace

void clip(const SurfaceLoop& loop_a, const SurfaceLoop& loop_b, bool a_is_window, double tolerance,
          ClipBuffers& buffers, std::vector<OverlayPoint>& points) {
  const SurfaceLoop& subject = a_is_window ? loop_b : loop_a;
  const Cutter cutter{a_is_window ? loop_a : loop_b, subject, a_is_window};
  const FeatureKind kind = a_is_window ? FeatureKind::vertex_b : FeatureKind::vertex_a;
  const double sign = twice_area(cutter.window) < 0 ? -1.0 : 1.0;
  buffers.now.clear();
  for (const LoopCorner& c : subject.corners)
    buffers.now.push_back({c.u,
                           c.v,
                           {kind, c.vertex, -1},
                           {cutter.window.hu, cutter.window.hv},
                           c.edge,
                           static_cast<int>(buffers.now.size()),
                           -1,
                           0});
  const SideOrder order(cutter.window);
  for (std::size_t i = 0; i < cutter.window.corners.size() && !buffers.now.empty(); ++i) {
    const std::size_t k = order[i];
    const Side side = side_of(cutter.window, k, sign);
    double least = 0;
    for (Corner& c : buffers.now) least = std::min(least, c.distance = side.distance(c.u, c.v));
    if (least >= -tolerance) continue;
    cut_by_side(cutter, static_cast<int>(k), side, tolerance, buffers.now, buffers.next);
    buffers.now.swap(buffers.next);
  }
  drop_coincident(tolerance, buffers.now);
  for (const Corner& c : buffers.now) {
    const double height_a = loop_a.height(c.u, c.v);
    points.push_back({c.u, c.v, c.feature, height_a, loop_b.height(c.u, c.v) - height_a, c.slope});
  }
}

}  // namespace nilas::detect
