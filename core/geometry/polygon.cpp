#include "core/geometry/polygon.h"

#include <algorithm>
#include <limits>

#include "core/geometry/orientation.h"

namespace nilas::geometry {

namespace {

/// p on the closed segment a b.
bool on_segment(const Vec2& a, const Vec2& b, const Vec2& p) {
  return p.x() >= std::min(a.x(), b.x()) && p.x() <= std::max(a.x(), b.x()) && p.y() >= std::min(a.y(), b.y()) &&
         p.y() <= std::max(a.y(), b.y()) && orientation(a, b, p) == 0;
}

bool segments_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (std::max(a.x(), b.x()) < std::min(c.x(), d.x()) || std::max(c.x(), d.x()) < std::min(a.x(), b.x())) return false;
  if (orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0) return true;
  return on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b);
}

/// Sign of the turn at b, 0 when it is straight within k_straight_angle.
int turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 in = b - a, out = c - b;
  const double sine = cross2(in, out), allowed = k_straight_angle * in.norm() * out.norm();
  if (in.dot(out) > 0 && std::abs(sine) <= allowed) return 0;
  return orientation(a, b, c);
}

/// Largest separation of b from a over a's edge normals.
double edge_separation(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 e = (a[(i + 1) % a.size()] - a[i]).normalized(), n(e.y(), -e.x());
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& p : b) nearest = std::min(nearest, n.dot(p - a[i]));
    best = std::max(best, nearest);
  }
  return best;
}

}  // namespace

bool is_simple(const std::vector<Vec2>& outline) {
  const std::size_t n = outline.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % n], &c = outline[(i + 2) % n];
    if (a == b || !a.allFinite()) return false;
    // neighbours may share their vertex only: no folding back
    if ((b - a).dot(c - b) < 0 && orientation(a, b, c) == 0) return false;
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (segments_meet(a, b, outline[j], outline[(j + 1) % n])) return false;
    }
  }
  return true;
}

bool is_convex(const std::vector<Vec2>& outline) {
  const std::size_t n = outline.size();
  int way = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const int s = turn(outline[i], outline[(i + 1) % n], outline[(i + 2) % n]);
    if (s != 0 && way != 0 && s != way) return false;
    if (s != 0) way = s;
  }
  return way != 0 && is_simple(outline);
}

std::vector<int> corners(const std::vector<Vec2>& outline) {
  const std::size_t n = outline.size();
  std::vector<int> found;
  for (std::size_t i = 0; i < n; ++i)
    if (turn(outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]) != 0) found.push_back(static_cast<int>(i));
  return found;
}

bool contains(const std::vector<Vec2>& outline, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if (on_segment(a, b, point)) return true;
    const bool up = a.y() <= point.y() && b.y() > point.y(), down = b.y() <= point.y() && a.y() > point.y();
    // a ray towards +x crosses an edge that passes the point on its right-hand side
    if ((up && orientation(a, b, point) > 0) || (down && orientation(a, b, point) < 0)) inside = !inside;
  }
  return inside;
}

double width_behind(const std::vector<Vec2>& outline, int i) {
  const auto n = static_cast<int>(outline.size());
  const Vec2 edge = outline[(i + 1) % n] - outline[i], middle = outline[i] + 0.5 * edge;
  const Vec2 along = edge.normalized(), inwards(-along.y(), along.x());
  double width = std::numeric_limits<double>::infinity();
  for (int k = 0; k < n; ++k) {
    if (k == i) continue;
    const Vec2 from = outline[k] - middle, to = outline[(k + 1) % n] - middle;
    const double right = cross2(inwards, from), left = cross2(inwards, to);
    if ((right <= 0) != (left <= 0)) {
      const double way = (inwards.dot(from) * left - inwards.dot(to) * right) / (left - right);
      if (way > 0) width = std::min(width, way);
    }
    const bool is_of_neighbours = k == (i + n - 1) % n || k == (i + 1) % n || k == (i + 2) % n;
    const double height = inwards.dot(from);
    if (!is_of_neighbours && height > 0 && std::abs(along.dot(from)) <= 0.5 * edge.norm())
      width = std::min(width, height);
  }
  return width;
}

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  // Andrew's monotone chain: lower hull left to right, then upper hull back
  std::vector<Vec2> hull;
  const auto chain = [&](auto first, auto last, std::size_t floor) {
    for (auto p = first; p != last; ++p) {
      while (hull.size() >= floor + 2 && orientation(hull[hull.size() - 2], hull.back(), *p) <= 0) hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();
  };
  chain(points.begin(), points.end(), 0);
  chain(points.rbegin(), points.rend(), hull.size());
  return hull;
}

double convex_overlap(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return -std::max(edge_separation(a, b), edge_separation(b, a));
}

}  // namespace nilas::geometry
