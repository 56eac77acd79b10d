#include "contact/detect/surface/point_reduction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/order_free_sum.h"

namespace nilas::detect {

namespace {

/// Largest number of candidate points; above it the number of quadrilaterals (2380 at 17) takes too long.
constexpr std::size_t k_most_candidates = 17;
/// Power of a point's closeness: a gap half as large as the margin counts 1/256 of a touching point.
constexpr double k_sharpness = 8;
/// Gaps that differ by less than this share of the points' spread count as alike, whatever the margin [-].
constexpr double k_least_slope = 1e-4;
/// Weight of the points' spread relative to their area [-]. It decides where the points lie in line and span no area.
constexpr double k_spread_weight = 0.01;
/// Largest tilt of a pair in one step [-]. A floe of half a metre that a hull overturns at 0.3 m/s turns by 0.01 in
/// 0.01 s.
constexpr double k_step_tilt = 0.02;

using Points = std::vector<OverlayPoint>;
using Four = std::array<int, k_spread_points>;  ///< indices in the list of points

struct Mean {
  double u = 0, v = 0;
};

Mean mean_of(const Points& points) {
  OrderFreeSum u, v;
  for (const OverlayPoint& p : points) {
    u.add(p.u);
    v.add(p.v);
  }
  const auto count = static_cast<double>(points.size());
  return {u.value() / count, v.value() / count};
}

/// Returns a number that rises with the angle of (u, v), without trigonometry; 0 at the middle itself.
double angle_rank(double u, double v) {
  const double sum = std::abs(u) + std::abs(v);
  if (sum == 0) return 0;
  const double r = v / sum;
  return u < 0 ? 2.0 - r : (v < 0 ? 4.0 + r : r);
}

void sort_around(const Mean& mean, Points& points) {
  const auto rank = [&](const OverlayPoint& p) { return angle_rank(p.u - mean.u, p.v - mean.v); };
  constexpr std::size_t k_few = 32;
  if (points.size() > k_few) {
    std::sort(points.begin(), points.end(),
              [&](const OverlayPoint& p, const OverlayPoint& q) { return rank(p) < rank(q); });
    return;
  }
  // the same order with each rank computed once
  std::array<std::pair<double, int>, k_few> order;
  std::array<OverlayPoint, k_few> unsorted;
  for (std::size_t i = 0; i < points.size(); ++i) order[i] = {rank(points[i]), static_cast<int>(i)};
  std::copy(points.begin(), points.end(), unsorted.begin());
  std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(points.size()),
            [](const auto& p, const auto& q) { return p.first < q.first; });
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = unsorted[order[i].second];
}

Points::const_iterator find(const Points& points, const Feature& feature) {
  return std::find_if(points.begin(), points.end(), [&](const OverlayPoint& p) { return p.feature == feature; });
}

double cross(const OverlayPoint& p, const OverlayPoint& q, const OverlayPoint& r, const OverlayPoint& s) {
  return (q.u - p.u) * (s.v - r.v) - (q.v - p.v) * (s.u - r.u);
}

/// Keeps the deepest points, and those that touch first when the pair tilts about eight axes by half or all of what it
/// may in a step. Points that tie are all kept.
void keep_first_to_touch(double deepest, double tolerance, Points& points) {
  constexpr int k_axes = 8;
  std::vector<char> kept(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) kept[i] = points[i].gap <= deepest ? 1 : 0;
  std::vector<double> height(points.size());
  for (int axis = 0; axis < k_axes; ++axis)
    for (double tilt : {0.5 * k_step_tilt, k_step_tilt}) {
      const double angle = 2.0 * k_pi * axis / k_axes;
      const double along_u = tilt * std::cos(angle), along_v = tilt * std::sin(angle);
      for (std::size_t i = 0; i < points.size(); ++i)
        height[i] = points[i].gap - along_u * points[i].u - along_v * points[i].v;
      const double least = *std::min_element(height.begin(), height.end()) + tolerance;
      for (std::size_t i = 0; i < points.size(); ++i) kept[i] = kept[i] != 0 || height[i] <= least ? 1 : 0;
    }
  std::size_t place = 0;
  std::erase_if(points, [&](const OverlayPoint&) { return kept[place++] == 0; });
}

/// Removes the points that add least to the outline until few enough remain. At least one that is not above `deepest`
/// stays.
void drop_flat_corners(Points& points, double deepest) {
  auto deep = std::count_if(points.begin(), points.end(), [&](const OverlayPoint& p) { return p.gap <= deepest; });
  while (points.size() > k_most_candidates) {
    std::size_t flattest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const OverlayPoint& before = points[(i + points.size() - 1) % points.size()];
      const OverlayPoint& after = points[(i + 1) % points.size()];
      const double area = std::abs(cross(before, points[i], before, after));
      if ((points[i].gap <= deepest && deep == 1) || area >= least) continue;
      least = area;
      flattest = i;
    }
    deep -= points[flattest].gap <= deepest ? 1 : 0;
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(flattest));
  }
}

/// One number per candidate point. Most pairs of floes come here in every step, so nothing is allocated.
template <class Number>
using PerPoint = std::array<Number, k_most_candidates>;
/// A set of candidate points, one bit each.
using Members = std::uint32_t;
constexpr Members member(int i) { return Members{1} << i; }
Members members_of(const Four& four) { return member(four[0]) | member(four[1]) | member(four[2]) | member(four[3]); }

/// The image of each point in an axis through the mean of all; none where one of them has none.
class Images {
 public:
  Images(const Points& points, const Mean& mean, double sign_u, double sign_v, double tolerance) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const OverlayPoint& p = points[i];
      const double u = sign_u * (p.u - mean.u), v = sign_v * (p.v - mean.v);
      const auto image = std::find_if(points.begin(), points.end(), [&](const OverlayPoint& q) {
        return std::abs(q.u - mean.u - u) + std::abs(q.v - mean.v - v) + std::abs(q.gap - p.gap) <= tolerance;
      });
      if (image == points.end()) return;
      of_[i] = member(static_cast<int>(image - points.begin()));
    }
    exist_ = true;
  }
  /// Returns whether a set is its own image.
  bool keep(const Four& four) const {
    if (!exist_) return false;
    const Members images = of_[four[0]] | of_[four[1]] | of_[four[2]] | of_[four[3]];
    return (images & ~members_of(four)) == 0;
  }

 private:
  PerPoint<Members> of_{};
  bool exist_ = false;
};

/// The merits of a set of four that decide first. Larger is better, and a mirror does not change them.
struct Merit {
  double symmetry_v = 0, area = -std::numeric_limits<double>::infinity();
  double closeness = 0;  ///< a factor of the area, and so of its rounding

  /// Returns 1 where this is better, -1 where the other is, and 0 for a tie.
  int compared(const Merit& other, double tie) const {
    const double area_tie = tie * std::max(closeness, other.closeness);
    if (std::abs(symmetry_v - other.symmetry_v) > tie) return symmetry_v > other.symmetry_v ? 1 : -1;
    if (std::abs(area - other.area) > area_tie) return area > other.area ? 1 : -1;
    return 0;
  }
};

/// The merits that decide ties, in this order.
struct LesserMerit {
  double centring = 0, symmetry_u = 0, length = 0, forward = 0;

  bool beats(const LesserMerit& other, double tie) const {
    for (const double LesserMerit::*part :
         {&LesserMerit::centring, &LesserMerit::symmetry_u, &LesserMerit::length, &LesserMerit::forward})
      if (std::abs(this->*part - other.*part) > tie) return this->*part > other.*part;
    return false;
  }
};

class SetChoice {
 public:
  /// `points`: at most k_most_candidates.
  SetChoice(const Points& points, double deepest, double margin, double tolerance)
      : points_(points),
        centre_(mean_of(points)),
        deepest_(deepest),
        across_(points, centre_, 1, -1, tolerance),
        along_(points, centre_, -1, 1, tolerance) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      u_[i] = points[i].u - centre_.u;
      v_[i] = points[i].v - centre_.v;
      square_[i] = u_[i] * u_[i] + v_[i] * v_[i];
      reach_ = std::max({reach_, std::abs(u_[i]), std::abs(v_[i])});
      if (points[i].gap <= deepest + tolerance) deep_ |= member(static_cast<int>(i));
    }
    range_ = std::max(margin - deepest, k_least_slope * reach_);
    for (std::size_t i = 0; i < points.size(); ++i)
      closeness_[i] = std::pow(1 - (points[i].gap - deepest) / range_, k_sharpness);
    tie_ = tolerance * reach_;
  }

  void consider(const Four& four) {
    if ((members_of(four) & deep_) == 0) return;
    const Merit merit = merit_of(four);
    const int compared = merit.compared(most_, tie_);
    if (compared < 0 || (compared == 0 && !lesser_merit_of(four).beats(lesser_merit_of(best_), tie_))) return;
    most_ = merit;
    best_ = four;
  }
  const Four& best() const { return best_; }
  /// Returns the gap above which points are not nearly as deep as the deepest [m].
  double most_kept_gap() const { return deepest_ + k_kept_depth * range_; }

  /// Returns the first four of these features, if the points have them and they are nearly as good as the best set.
  std::optional<Four> kept(std::span<const Feature> last) const {
    if (last.size() < k_spread_points) return std::nullopt;
    Four four{};
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < k_spread_points; ++k) {
      const auto found = find(points_, last[k]);
      if (found == points_.end()) return std::nullopt;
      four[k] = static_cast<int>(found - points_.begin());
      nearest = std::min(nearest, found->gap);
    }
    std::sort(four.begin(), four.end());
    const Merit merit = merit_of(four);
    const bool nearly_as_good = nearest <= most_kept_gap() && merit.symmetry_v + tie_ >= most_.symmetry_v &&
                                merit.area > k_kept_area * most_.area;
    return nearly_as_good ? std::optional(four) : std::nullopt;
  }

 private:
  /// Returns the square of the distance between the mean of a set and that of all points.
  double distance_of(const Four& four) const {
    Mean mean;
    for (const int i : four) {
      mean.u += u_[i] / k_spread_points;
      mean.v += v_[i] / k_spread_points;
    }
    return mean.u * mean.u + mean.v * mean.v;
  }

  Merit merit_of(const Four& four) const {
    Merit merit{0, 0, 1};
    double spread = 0;
    for (const int i : four) {
      spread += square_[i];
      merit.closeness *= closeness_[i];
    }
    const double area = std::abs(cross(points_[four[0]], points_[four[2]], points_[four[1]], points_[four[3]]));
    merit.symmetry_v = across_.keep(four) ? reach_ * reach_ : 0.0;
    merit.area = (area + k_spread_weight * (spread - k_spread_points * distance_of(four))) * merit.closeness;
    return merit;
  }

  LesserMerit lesser_merit_of(const Four& four) const {
    LesserMerit merit;
    for (const int i : four) {
      const double u = u_[i];
      // these powers distinguish a square on its corner from one on its side, and a set from the same turned by half a
      // turn
      merit.length += u * u * u * u / (reach_ * reach_);
      merit.forward += u * u * u / reach_;
    }
    merit.centring = -distance_of(four);
    merit.symmetry_u = along_.keep(four) ? reach_ * reach_ : 0.0;
    return merit;
  }

  const Points& points_;
  Mean centre_;
  double deepest_, reach_ = 0, range_ = 0, tie_ = 0;
  PerPoint<double> u_, v_, square_;  ///< places from the middle of all, and the squares of their distances from it
  /// Weight of each point: 1 at the depth of the deepest, 0 at the margin, so that points about to touch count more.
  PerPoint<double> closeness_;
  Members deep_ = 0;
  Images across_, along_;
  Merit most_;
  Four best_{};
};

/// Returns the gap at p of the plane through three points; infinite when p lies outside their triangle.
double gap_inside(const OverlayPoint& a, const OverlayPoint& b, const OverlayPoint& c, const OverlayPoint& p) {
  const double area = cross(a, b, a, c);
  const double at_a = cross(p, b, p, c) / area, at_b = cross(p, c, p, a) / area;
  const double at_c = 1 - at_a - at_b;
  if (!(at_a >= 0 && at_b >= 0 && at_c >= 0)) return std::numeric_limits<double>::infinity();
  return at_a * a.gap + at_b * b.gap + at_c * c.gap;
}

/// Returns the gap that a and b leave at p when the pair tilts about their line.
double gap_beside(const OverlayPoint& a, const OverlayPoint& b, const OverlayPoint& p) {
  const double du = b.u - a.u, dv = b.v - a.v, square = du * du + dv * dv;
  const double t = square > 0 ? std::clamp(((p.u - a.u) * du + (p.v - a.v) * dv) / square, 0.0, 1.0) : 0.0;
  const double away = std::hypot(a.u + t * du - p.u, a.v + t * dv - p.v);
  return a.gap + t * (b.gap - a.gap) + k_step_tilt * away;
}

/// Returns how far p can sink while all points of `kept` only just touch [m]. The gap of a rigid pair is affine over
/// the contact plane, so three points around p, or two on either side of it, hold it up.
double left_open(const Points& kept, const OverlayPoint& p) {
  double held = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kept.size(); ++i)
    for (std::size_t j = i + 1; j < kept.size(); ++j) {
      held = std::min(held, gap_beside(kept[i], kept[j], p));
      for (std::size_t k = j + 1; k < kept.size(); ++k) held = std::min(held, gap_inside(kept[i], kept[j], kept[k], p));
    }
  return held - p.gap;
}

/// Adds the points that can sink farthest until none can sink by more than `cover`. Points that tie are added together,
/// or not at all where there is no room for all. So a mirrored contact keeps the mirrored points.
void cover_the_rest(double tolerance, double cover, const Points& points, Points& kept) {
  std::vector<double> open(points.size());
  for (;;) {
    for (std::size_t i = 0; i < points.size(); ++i) open[i] = left_open(kept, points[i]);
    const double most = *std::max_element(open.begin(), open.end());
    if (most <= cover) return;
    const auto tied = [&](double x) { return x >= most - tolerance; };
    if (kept.size() + static_cast<std::size_t>(std::count_if(open.begin(), open.end(), tied)) > k_most_points) return;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (tied(open[i])) kept.push_back(points[i]);
  }
}

Points chosen(const Points& points, const Four& four) {
  Points of_four;
  of_four.reserve(k_most_points);
  for (int i : four) of_four.push_back(points[i]);
  return of_four;
}

/// Returns the four of the last call and the points that stay with them, so that the deepest point is always included.
/// These are the further points of that call while they are nearly as deep, and the deepest of the best four where it
/// is still missing. It alone joins when there is no room for all.
Points beside_the_kept(const SetChoice& choice, const Points& points, const Points& four, double deepest,
                       std::span<const Feature> last) {
  const auto is_deepest = [&](const OverlayPoint& p) { return p.gap <= deepest; };
  Points further;
  for (const Feature& feature : last.subspan(k_spread_points))
    if (const auto p = find(points, feature); p != points.end() && p->gap <= choice.most_kept_gap())
      further.push_back(*p);
  if (std::any_of(four.begin(), four.end(), is_deepest) || std::any_of(further.begin(), further.end(), is_deepest))
    return further;
  Points deep = chosen(points, choice.best());
  std::erase_if(deep, std::not_fn(is_deepest));
  if (four.size() + further.size() + deep.size() > k_most_points) return deep;
  further.insert(further.end(), deep.begin(), deep.end());
  return further;
}

/// Returns the four of `points` (in turn around their middle) that spread best, or those of the last call with the
/// points that stay with them.
Points best_four(const Points& points, double deepest, double margin, double tolerance, std::span<const Feature> last) {
  SetChoice choice(points, deepest, margin, tolerance);
  const int count = static_cast<int>(points.size());
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j)
      for (int k = j + 1; k < count; ++k)
        for (int l = k + 1; l < count; ++l) choice.consider({i, j, k, l});
  const std::optional<Four> kept = choice.kept(last);
  Points four = chosen(points, kept.value_or(choice.best()));
  if (!kept) return four;
  const Points further = beside_the_kept(choice, points, four, deepest + tolerance, last);
  four.insert(four.end(), further.begin(), further.end());
  return four;
}

}  // namespace

std::size_t keep_spread_points(double tolerance, double margin, double cover, Points& points,
                               std::span<const Feature> last) {
  if (points.size() <= k_spread_points) return points.size();
  sort_around(mean_of(points), points);
  const auto shallower = [](const OverlayPoint& p, const OverlayPoint& q) { return p.gap < q.gap; };
  const double deepest = std::min_element(points.begin(), points.end(), shallower)->gap;
  const bool covers = std::isfinite(cover);
  const Points all = covers ? points : Points();
  if (points.size() > k_most_candidates) keep_first_to_touch(deepest + tolerance, tolerance, points);
  drop_flat_corners(points, deepest + tolerance);
  if (points.size() > k_spread_points) {
    const Points best = best_four(points, deepest, margin, tolerance, last);
    points.assign(best.begin(), best.end());  // in the room that the next pair uses too
  }
  const std::size_t kept = points.size();
  if (covers) cover_the_rest(tolerance, cover, all, points);
  return kept;
}

}  // namespace nilas::detect
