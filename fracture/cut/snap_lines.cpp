/// This file includes CGAL, whose kernels need directed rounding: see fracture/CMakeLists.txt.
#include "fracture/cut/snap_lines.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/geometry/orientation.h"

namespace nilas::fracture {

namespace {

constexpr int k_max_passes = 16;

/// The foot of p on the segment a b, as a share of it in [0, 1].
double foot_share(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 along = b - a;
  return std::clamp(along.dot(p - a) / along.squaredNorm(), 0.0, 1.0);
}

double distance_to_segment(const Vec2& a, const Vec2& b, const Vec2& p) {
  const double share = foot_share(a, b, p);
  if (share <= 0) return (p - a).norm();
  if (share >= 1) return (p - b).norm();
  // The difference to the nearer end loses fewer digits.
  return std::abs(cross2(b - a, p - (share < 0.5 ? a : b))) / (b - a).norm();
}

/// The point where the lines a b and c d cross, computed exactly, then rounded.
Vec2 crossing_point(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  using Exact = CGAL::Exact_rational;
  const Exact ax(a.x()), ay(a.y()), cx(c.x()), cy(c.y());
  const Exact ux = Exact(b.x()) - ax, uy = Exact(b.y()) - ay, vx = Exact(d.x()) - cx, vy = Exact(d.y()) - cy;
  const Exact share = ((cx - ax) * vy - (cy - ay) * vx) / (ux * vy - uy * vx);
  return {CGAL::to_double(Exact(ax + share * ux)), CGAL::to_double(Exact(ay + share * uy))};
}

bool cross_properly(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (std::max(a.x(), b.x()) < std::min(c.x(), d.x()) || std::max(c.x(), d.x()) < std::min(a.x(), b.x())) return false;
  if (std::max(a.y(), b.y()) < std::min(c.y(), d.y()) || std::max(c.y(), d.y()) < std::min(a.y(), b.y())) return false;
  return geometry::orientation(a, b, c) * geometry::orientation(a, b, d) < 0 &&
         geometry::orientation(c, d, a) * geometry::orientation(c, d, b) < 0;
}

struct Segment {
  int line;  ///< The index of the crack, or -1 for the outline.
  int a, b;
  std::vector<int> through;  ///< Points to be put between a and b.
};

class Snapper {
 public:
  Snapper(const std::vector<Vec2>& outline, const std::vector<std::vector<Vec2>>& cracks, double resolution)
      : num_corners_(static_cast<int>(outline.size())), resolution_(resolution) {
    out_.points = outline;
    for (int i = 0; i < num_corners_; ++i) out_.outline.push_back(i);
    on_outline_.insert(out_.outline.begin(), out_.outline.end());
    for (const auto& crack : cracks) {
      out_.cracks.emplace_back();
      for (const Vec2& p : crack) append(out_.cracks.back(), add_crack_vertex(p));
    }
    out_.given.assign(out_.points.size(), 1);
  }

  SnappedLines run() {
    for (int pass = 0; pass < k_max_passes && !out_.settled; ++pass) {
      const bool crossed = split(&Snapper::find_crossings);
      const bool near = split(&Snapper::find_near_points);
      out_.settled = !crossed && !near;
    }
    out_.given.resize(out_.points.size(), 0);
    out_.num_corners = num_corners_;
    return std::move(out_);
  }

 private:
  const Vec2& at(int i) const { return out_.points[i]; }

  static void append(std::vector<int>& line, int point) {
    if (line.empty() || line.back() != point) line.push_back(point);
  }

  /// The nearest point within the resolution that is `allowed`, or -1.
  template <class Allowed>
  int near_point(const Vec2& p, const Allowed& allowed) const {
    int best = -1;
    double least = resolution_;
    for (int i = 0; i < static_cast<int>(out_.points.size()); ++i)
      if (const double d = (at(i) - p).norm(); d <= least && allowed(i)) {
        least = d;
        best = i;
      }
    return best;
  }

  int near_point(const Vec2& p) const {
    return near_point(p, [](int) { return true; });
  }

  int add(const Vec2& p) {
    out_.points.push_back(p);
    return static_cast<int>(out_.points.size()) - 1;
  }

  /// Returns the index of a known point near p, else of a new one, which is on the outline's edge where that is near.
  int add_crack_vertex(const Vec2& p) {
    if (const int known = near_point(p); known >= 0) return known;
    for (int i = 0; i < num_corners_; ++i) {
      const Vec2 &a = at(i), &b = at((i + 1) % num_corners_);
      if (distance_to_segment(a, b, p) > resolution_) continue;
      const Vec2 foot = a + foot_share(a, b, p) * (b - a);
      const int known = near_point(foot);
      return known >= 0 ? known : add(foot);
    }
    return add(p);
  }

  /// Whether a segment may go through p. The outline visits a point only once, else it would fold.
  bool may_visit(const Segment& s, int p) const {
    if (s.line >= 0 || p == s.a || p == s.b) return true;
    return !is_on_outline(p) || std::find(s.through.begin(), s.through.end(), p) != s.through.end();
  }

  bool is_on_outline(int p) const { return on_outline_.count(p) > 0; }

  void lead_through(Segment& s, int p) {
    if (p == s.a || p == s.b) return;
    s.through.push_back(p);
    if (s.line < 0) on_outline_.insert(p);
  }

  /// Returns the point of a crossing: a near end of either segment, else another near point, else a new one.
  int crossing(const Segment& s, const Segment& t) {
    const Vec2 p = crossing_point(at(s.a), at(s.b), at(t.a), at(t.b));
    const auto allowed = [&](int i) { return may_visit(s, i) && may_visit(t, i); };
    const auto end = [&](int i) { return (i == s.a || i == s.b || i == t.a || i == t.b) && allowed(i); };
    if (const int known = near_point(p, end); known >= 0) return known;
    const int known = near_point(p, allowed);
    return known >= 0 ? known : add(p);
  }

  void find_crossings(std::vector<Segment>& segments) {
    for (std::size_t i = 0; i < segments.size(); ++i)
      for (std::size_t j = i + 1; j < segments.size(); ++j) {
        Segment &s = segments[i], &t = segments[j];
        if (s.line < 0 && t.line < 0) continue;
        if (!cross_properly(at(s.a), at(s.b), at(t.a), at(t.b))) continue;
        const int p = crossing(s, t);
        lead_through(s, p);
        lead_through(t, p);
      }
  }

  bool passes(const Segment& s, int p) const {
    return p != s.a && p != s.b && distance_to_segment(at(s.a), at(s.b), at(p)) <= resolution_;
  }

  void find_near_points(std::vector<Segment>& segments) {
    for (Segment& s : segments)
      for (int p = 0; p < static_cast<int>(out_.points.size()); ++p)
        if ((s.line >= 0 || !is_on_outline(p)) && passes(s, p)) lead_through(s, p);
  }

  std::vector<Segment> segments() const {
    std::vector<Segment> all;
    const auto& o = out_.outline;
    for (std::size_t i = 0; i < o.size(); ++i) all.push_back({-1, o[i], o[(i + 1) % o.size()], {}});
    for (std::size_t c = 0; c < out_.cracks.size(); ++c)
      for (std::size_t i = 1; i < out_.cracks[c].size(); ++i)
        all.push_back({static_cast<int>(c), out_.cracks[c][i - 1], out_.cracks[c][i], {}});
    return all;
  }

  /// Sorts the points of a segment along it.
  void sort_through(Segment& s) const {
    const Vec2 along = at(s.b) - at(s.a);
    std::sort(s.through.begin(), s.through.end());
    s.through.erase(std::unique(s.through.begin(), s.through.end()), s.through.end());
    std::stable_sort(s.through.begin(), s.through.end(),
                     [&](int i, int j) { return along.dot(at(i) - at(s.a)) < along.dot(at(j) - at(s.a)); });
  }

  /// Splits the segments at the points that `find` puts through them. Returns whether a line got another point.
  bool split(void (Snapper::*find)(std::vector<Segment>&)) {
    std::vector<Segment> all = segments();
    (this->*find)(all);
    bool changed = false;
    out_.outline.clear();
    for (auto& crack : out_.cracks) crack.resize(std::min<std::size_t>(crack.size(), 1));
    for (Segment& s : all) {
      changed = changed || !s.through.empty();
      sort_through(s);
      if (s.line < 0) {
        append(out_.outline, s.a);
        for (const int p : s.through) append(out_.outline, p);
      } else {
        auto& crack = out_.cracks[s.line];
        for (const int p : s.through) append(crack, p);
        append(crack, s.b);
      }
    }
    return changed;
  }

  int num_corners_;
  std::set<int> on_outline_;
  double resolution_;
  SnappedLines out_;
};

}  // namespace

double snap_resolution(const std::vector<Vec2>& outline) {
  constexpr double k_share = 0x1p-46;
  double largest = 0;
  for (const Vec2& p : outline) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return k_share * largest;
}

SnappedLines snap_lines(const std::vector<Vec2>& outline, const std::vector<std::vector<Vec2>>& cracks,
                        double resolution) {
  return Snapper(outline, cracks, resolution).run();
}

}  // namespace nilas::fracture
