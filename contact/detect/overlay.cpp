#include "contact/detect/overlay.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nilas {

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
  double u, v;    ///< its middle: the same bits whichever end is listed first
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

/// Edges whose directions differ by less than this sine do not span a tangent plane [-].
constexpr double k_spanning_sine = 0.1;

/// Slope of the plane through two crossing edges, one on each surface; the mean of the surfaces' own when the edges run
/// alongside.
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

  /// What meets where the edge that begins at `from` leaves through a side of the window.
  Feature feature(const Corner& from, int side) const {
    const int window_edge = window.corners[side].edge;
    if (from.side < 0)
      return a_is_window ? Feature{FeatureKind::crossing, window_edge, from.edge}
                         : Feature{FeatureKind::crossing, from.edge, window_edge};
    // The edge lies on an earlier side of the window: the point is the window's corner between both.
    const int count = static_cast<int>(window.corners.size());
    const FeatureKind kind = a_is_window ? FeatureKind::vertex_a : FeatureKind::vertex_b;
    if (from.side == (side + 1) % count) return {kind, window.corners[from.side].vertex, -1};
    if (side == (from.side + 1) % count) return {kind, window.corners[side].vertex, -1};
    return {FeatureKind::window_sides, window.corners[from.side].edge, window_edge};
  }

  Slope slope(const Corner& inner, const Corner& outer, const Feature& feature, int side) const {
    if (feature.kind == FeatureKind::vertex_a || feature.kind == FeatureKind::vertex_b)
      return {subject.hu, subject.hv};  // a corner of the window on the subject's face
    const LoopCorner& p = window.corners[side];
    const LoopCorner& q = window.corners[(side + 1) % window.corners.size()];
    return crossing_slope(window, q.u - p.u, q.v - p.v, subject, outer.u - inner.u, outer.v - inner.v);
  }

  /// Always from the inner corner to the outer one, whichever way the loop runs.
  Corner cut(const Corner& inner, const Corner& outer, const Corner& from, int side) const {
    const double t = inner.distance / (inner.distance - outer.distance);
    Corner corner;
    corner.u = inner.u + t * (outer.u - inner.u);
    corner.v = inner.v + t * (outer.v - inner.v);
    corner.feature = feature(from, side);
    corner.slope = slope(inner, outer, corner.feature, side);
    return corner;
  }
};

void cut_by_side(const Cutter& cutter, int side, double tolerance, const std::vector<Corner>& in,
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
      out.push_back(cutter.cut(corner, following, corner, side));
      out.back().side = side;
    } else if (following.distance > tolerance) {
      out.push_back(cutter.cut(following, corner, corner, side));
      out.back().edge = corner.edge;
      out.back().side = corner.side;
    }
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
    buffers.now.push_back({c.u, c.v, {kind, c.vertex, -1}, {cutter.window.hu, cutter.window.hv}, c.edge, -1, 0});
  for (std::size_t k = 0; k < cutter.window.corners.size() && !buffers.now.empty(); ++k) {
    const Side side = side_of(cutter.window, k, sign);
    double least = 0;
    for (Corner& c : buffers.now) least = std::min(least, c.distance = side.distance(c.u, c.v));
    if (least >= -tolerance) continue;
    cut_by_side(cutter, static_cast<int>(k), tolerance, buffers.now, buffers.next);
    buffers.now.swap(buffers.next);
  }
  for (const Corner& c : buffers.now) {
    const double height_a = loop_a.height(c.u, c.v);
    points.push_back({c.u, c.v, c.feature, height_a, loop_b.height(c.u, c.v) - height_a, c.slope});
  }
}

}  // namespace nilas
