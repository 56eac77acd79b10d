#include "contact/detect/point_reduction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nilas {

namespace {

/// Above this many points the number of quadrilaterals (1820 at 16) is not worth its time; flat ones are dropped first.
constexpr std::size_t k_most_candidates = 16;
/// Power of a point's closeness: half way to the margin counts 1/256 of touching.
constexpr double k_sharpness = 8;
/// Gaps that differ by less than this share of the points' reach are alike, whatever the margin [-].
constexpr double k_least_slope = 1e-4;
/// Weight of the points' spread beside their area [-]: decides where they lie in line and span none.
constexpr double k_spread_weight = 0.01;

using Points = std::vector<OverlayPoint>;
using Four = std::array<int, k_most_points>;  ///< places in the list of points

struct Mean {
  double u = 0, v = 0;
};

Mean mean_of(const Points& points) {
  Mean mean;
  for (const OverlayPoint& p : points) {
    mean.u += p.u;
    mean.v += p.v;
  }
  const auto count = static_cast<double>(points.size());
  return {mean.u / count, mean.v / count};
}

/// Rises with the angle of (u, v), without trigonometry.
double angle_rank(double u, double v) {
  const double r = v / (std::abs(u) + std::abs(v));
  return u < 0 ? 2.0 - r : (v < 0 ? 4.0 + r : r);
}

void sort_around(const Mean& mean, Points& points) {
  std::sort(points.begin(), points.end(), [&](const OverlayPoint& p, const OverlayPoint& q) {
    return angle_rank(p.u - mean.u, p.v - mean.v) < angle_rank(q.u - mean.u, q.v - mean.v);
  });
}

double cross(const OverlayPoint& p, const OverlayPoint& q, const OverlayPoint& r, const OverlayPoint& s) {
  return (q.u - p.u) * (s.v - r.v) - (q.v - p.v) * (s.u - r.u);
}

/// Drops the points that add least to the outline until few enough remain; one not above `deepest` stays.
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

/// Each point's image in an axis through the mean of all, or nothing when one of them has none.
class Images {
 public:
  Images(const Points& points, const Mean& mean, double sign_u, double sign_v, double tolerance) {
    for (const OverlayPoint& p : points) {
      const double u = sign_u * (p.u - mean.u), v = sign_v * (p.v - mean.v);
      const auto image = std::find_if(points.begin(), points.end(), [&](const OverlayPoint& q) {
        return std::abs(q.u - mean.u - u) + std::abs(q.v - mean.v - v) + std::abs(q.gap - p.gap) <= tolerance;
      });
      if (image == points.end()) {
        of_.clear();
        return;
      }
      of_.push_back(static_cast<int>(image - points.begin()));
    }
  }
  bool exist() const { return !of_.empty(); }
  /// True for a set that is its own image.
  bool keep(const Four& four) const {
    return exist() && std::all_of(four.begin(), four.end(),
                                  [&](int i) { return std::find(four.begin(), four.end(), of_[i]) != four.end(); });
  }

 private:
  std::vector<int> of_;
};

/// What a set of four is judged by, the first that differs deciding; all are the larger the better and unchanged by a
/// mirror.
struct Merit {
  double symmetry_v = 0, area = -std::numeric_limits<double>::infinity(), centring = 0, symmetry_u = 0, length = 0,
         forward = 0;

  bool beats(const Merit& other, double tie) const {
    for (const double Merit::*part :
         {&Merit::symmetry_v, &Merit::area, &Merit::centring, &Merit::symmetry_u, &Merit::length, &Merit::forward})
      if (std::abs(this->*part - other.*part) > tie) return this->*part > other.*part;
    return false;
  }
};

class SetChoice {
 public:
  SetChoice(const Points& points, double deepest, double margin, double tolerance)
      : points_(points),
        centre_(mean_of(points)),
        deepest_(deepest),
        across_(points, centre_, 1, -1, tolerance),
        along_(points, centre_, -1, 1, tolerance) {
    for (const OverlayPoint& p : points)
      reach_ = std::max({reach_, std::abs(p.u - centre_.u), std::abs(p.v - centre_.v)});
    range_ = std::max(margin - deepest, k_least_slope * reach_);
    tie_ = tolerance * reach_;
  }

  void consider(const Four& four, double tolerance) {
    const auto is_deep = [&](int i) { return points_[i].gap <= deepest_ + tolerance; };
    if (std::none_of(four.begin(), four.end(), is_deep)) return;
    const Merit merit = merit_of(four);
    if (!merit.beats(most_, tie_)) return;
    most_ = merit;
    best_ = four;
  }
  const Four& best() const { return best_; }

 private:
  /// 1 where all are as deep as the deepest, 0 at the margin: what is about to touch counts before what only might.
  double closeness(const Four& four) const {
    double product = 1;
    for (int i : four) {
      const double share = 1 - (points_[i].gap - deepest_) / range_;
      product *= std::pow(share, k_sharpness);
    }
    return product;
  }

  Merit merit_of(const Four& four) const {
    Merit merit;
    Mean mean;
    double spread = 0;
    for (int i : four) {
      const double u = points_[i].u - centre_.u, v = points_[i].v - centre_.v;
      mean.u += u / k_most_points;
      mean.v += v / k_most_points;
      spread += u * u + v * v;
      // Powers that tell a square on its corner from one on its side, and a set from the same turned half round.
      merit.length += u * u * u * u / (reach_ * reach_);
      merit.forward += u * u * u / reach_;
    }
    const double distance = mean.u * mean.u + mean.v * mean.v;
    const double area = std::abs(cross(points_[four[0]], points_[four[2]], points_[four[1]], points_[four[3]]));
    merit.symmetry_v = across_.keep(four) ? reach_ * reach_ : 0.0;
    merit.area = (area + k_spread_weight * (spread - k_most_points * distance)) * closeness(four);
    merit.centring = -distance;
    merit.symmetry_u = along_.keep(four) ? reach_ * reach_ : 0.0;
    return merit;
  }

  const Points& points_;
  Mean centre_;
  double deepest_, range_ = 0, reach_ = 0, tie_ = 0;
  Images across_, along_;
  Merit most_;
  Four best_{};
};

}  // namespace

void keep_spread_points(double tolerance, double margin, Points& points) {
  if (points.size() <= k_most_points) return;
  sort_around(mean_of(points), points);
  const auto shallower = [](const OverlayPoint& p, const OverlayPoint& q) { return p.gap < q.gap; };
  const double deepest = std::min_element(points.begin(), points.end(), shallower)->gap;
  drop_flat_corners(points, deepest + tolerance);
  SetChoice choice(points, deepest, margin, tolerance);
  const int count = static_cast<int>(points.size());
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j)
      for (int k = j + 1; k < count; ++k)
        for (int l = k + 1; l < count; ++l) choice.consider({i, j, k, l}, tolerance);
  Points kept;
  for (int i : choice.best()) kept.push_back(points[i]);
  points.swap(kept);
}

}  // namespace nilas
