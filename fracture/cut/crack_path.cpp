#include "fracture/cut/crack_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/geometry/polygon.h"

namespace nilas::fracture {

namespace {

constexpr double k_turn = 5 * k_deg;  ///< Angle between neighbouring directions through whole ice [rad].
constexpr int k_turns = 12;           ///< Number of these directions to each side.
constexpr double k_as_good = 1e-9;    ///< Relative differences of merits below this are rounding.
constexpr double k_beyond = 1e-6;     ///< Distance of the last point from the ice, over a segment.
constexpr double k_look = 1e-3;       ///< Directions that leave the ice within this share of a segment are dropped.
constexpr int k_most_segments = 100000;

/// A candidate for the next segment of the crack.
struct Way {
  Vec2 direction = Vec2::UnitX();
  double length = 0;     ///< [m]
  double omega = 0;      ///< Signed angle from that of the load [rad].
  double toughness = 0;  ///< [Pa sqrt(m)]
  double merit() const { return kink_release_rate(omega) / (toughness * toughness); }
};

class Growth {
 public:
  Growth(const std::vector<Vec2>& outline, double angle, double segment, double toughness, const LocalIce& ice)
      : outline_(outline), ahead_(direction_of(angle)), segment_(segment), toughness_(toughness), ice_(ice) {
    for (const Vec2& p : outline) size_ = std::max(size_, p.cwiseAbs().maxCoeff());
  }

  CrackPath from(const Vec2& start) const {
    CrackPath path{{start}, {}};
    for (int k = 0; k < k_most_segments; ++k) {
      const Vec2 at = path.points.back();
      const Way way = best_way(at);
      const double out = leaves(at, way.direction);
      const bool ends = out <= way.length + same();
      const double on = ends ? out + k_beyond * segment_ : first_line(at, way.direction, way.length);
      path.points.emplace_back(at + on * way.direction);
      path.toughness.push_back(way.toughness);
      // Rounding may have made the crack miss an edge.
      if (ends || !geometry::contains(outline_, path.points.back())) break;
    }
    return path;
  }

 private:
  /// The distance below which two points are the same [m].
  double same() const { return 1e-9 * size_; }

  double toughness_at(const Vec2& x) const { return ice_.fracture_toughness ? ice_.fracture_toughness(x) : toughness_; }

  Way through_ice(const Vec2& at, double omega) const {
    const Vec2 d(std::cos(omega) * ahead_.x() - std::sin(omega) * ahead_.y(),
                 std::sin(omega) * ahead_.x() + std::cos(omega) * ahead_.y());
    return {d, segment_, omega, toughness_at(at + 0.5 * segment_ * d)};
  }

  /// Adds the candidate along the weak line towards `end` where it turns by less than 90 degrees.
  void add_along(const Vec2& at, const Vec2& end, double strength, std::vector<Way>& ways) const {
    const Vec2 span = end - at;
    const double length = std::min(span.norm(), segment_);
    if (length <= same()) return;
    const Vec2 d = span.normalized();
    const double omega = std::atan2(cross2(ahead_, d), ahead_.dot(d));
    if (std::abs(omega) >= 0.5 * k_pi - 1e-6) return;
    ways.push_back({d, length, omega, strength * toughness_at(at + 0.5 * length * d)});
  }

  std::vector<Way> ways(const Vec2& at) const {
    std::vector<Way> all;
    for (int k = 1; k <= k_turns; ++k)
      for (const double omega : {k * k_turn, -k * k_turn}) all.push_back(through_ice(at, omega));
    for (const bodies::WeakLine& line : ice_.weak_lines)
      for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        const Vec2 &a = line.points[i], &b = line.points[i + 1];
        if (distance(at, a, b) > same()) continue;
        add_along(at, a, line.strength, all);
        add_along(at, b, line.strength, all);
      }
    const auto leaves_at_once = [&](const Way& way) {
      return !geometry::contains(outline_, at + k_look * segment_ * way.direction);
    };
    std::erase_if(all, leaves_at_once);
    return all;
  }

  Way best_way(const Vec2& at) const {
    const Way straight = through_ice(at, 0);
    Way best = straight;
    bool mirrored = false;
    for (const Way& way : ways(at)) {
      const double gain = way.merit() / best.merit() - 1;
      if (gain < -k_as_good) continue;
      const double turn = std::abs(way.omega) - std::abs(best.omega);
      if (gain <= k_as_good && turn > k_as_good) continue;
      const bool opposite = gain <= k_as_good && turn >= -k_as_good && way.omega * best.omega < 0;
      if (opposite) mirrored = true;
      if (gain <= k_as_good && turn >= -k_as_good) continue;
      best = way;
      mirrored = false;
    }
    return mirrored ? straight : best;
  }

  static double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 span = b - a;
    const double square = span.squaredNorm();
    const double share = square > 0 ? std::clamp((p - a).dot(span) / square, 0.0, 1.0) : 0;
    return (p - a - share * span).norm();
  }

  /// The distance along `d` at which the segment from a to b is crossed or touched [m]; infinite where it is not.
  double meets(const Vec2& at, const Vec2& d, const Vec2& a, const Vec2& b) const {
    constexpr double k_none = std::numeric_limits<double>::infinity();
    const Vec2 span = b - a;
    const double turn = cross2(d, span);
    if (std::abs(turn) <= 1e-12 * span.norm()) return k_none;
    const double on = cross2(a - at, span) / turn, share = cross2(a - at, d) / turn;
    const double slack = same() / span.norm();
    return on > same() && share >= -slack && share <= 1 + slack ? on : k_none;
  }

  /// The distance along `d` at which the crack leaves the ice [m]. A corner that it only touches does not count.
  double leaves(const Vec2& at, const Vec2& d) const {
    std::vector<double> edges;
    for (std::size_t i = 0; i < outline_.size(); ++i)
      edges.push_back(meets(at, d, outline_[i], outline_[(i + 1) % outline_.size()]));
    std::sort(edges.begin(), edges.end());
    for (const double on : edges)
      if (std::isfinite(on) && !geometry::contains(outline_, at + (on + k_beyond * segment_) * d)) return on;
    return std::numeric_limits<double>::infinity();
  }

  double first_line(const Vec2& at, const Vec2& d, double length) const {
    double first = length;
    for (const bodies::WeakLine& line : ice_.weak_lines)
      for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
        first = std::min(first, meets(at, d, line.points[i], line.points[i + 1]));
    return first;
  }

  const std::vector<Vec2>& outline_;
  Vec2 ahead_;
  double segment_, toughness_, size_ = 0;
  const LocalIce& ice_;
};

}  // namespace

double kink_release_rate(double omega) { return std::pow(std::cos(0.5 * omega), 4); }

double CrackPath::length() const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) sum += (points[i + 1] - points[i]).norm();
  return sum;
}

CrackPath crack_path(const std::vector<Vec2>& outline, const Vec2& start, double angle, double segment,
                     double toughness, const LocalIce& ice) {
  NILAS_DEMAND(segment > 0 && toughness > 0);
  return Growth(outline, angle, segment, toughness, ice).from(start);
}

}  // namespace nilas::fracture
