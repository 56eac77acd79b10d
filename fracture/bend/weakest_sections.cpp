#include "fracture/bend/weakest_sections.h"

#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace nilas::fracture {

namespace {

/// The range of the samples over the fan's radius. Beyond it stresses are a few per cent of the largest.
constexpr double k_first = 0.1, k_last = 3;
constexpr int k_samples = 59;  ///< Steps of 0.05.

/// The distances from `from` along the unit vector `d` at which the ray's line crosses the weak line [m].
std::vector<double> crossings(const bodies::WeakLine& line, const Vec2& from, const Vec2& d) {
  std::vector<double> found;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const Vec2 to_start = line.points[i] - from, span = line.points[i + 1] - line.points[i];
    const double turn = cross2(d, span);
    if (std::abs(turn) <= 1e-12 * span.norm()) continue;
    const double share = cross2(to_start, d) / turn;
    if (share >= 0 && share <= 1) found.push_back(cross2(to_start, span) / turn);
  }
  return found;
}

/// One ray of the fan, with the weakest of the sections that were judged on it.
class Ray {
 public:
  Ray(const WedgeFan& fan, int k, double strength, const LocalIce& ice)
      : fan_(fan),
        direction_(std::cos(ray_angle(fan, k)), std::sin(ray_angle(fan, k))),
        strength_(strength),
        ice_(ice) {}

  /// The places where weak lines cross, over the fan's radius, with the share of the strength that each line leaves.
  std::vector<std::pair<double, double>> lines() const {
    std::vector<std::pair<double, double>> found;
    for (const bodies::WeakLine& line : ice_.weak_lines)
      for (const double distance : crossings(line, fan_.apex, direction_))
        if (distance >= k_first * fan_.radius && distance <= k_last * fan_.radius)
          found.emplace_back(distance / fan_.radius, line.strength);
    return found;
  }
  /// Judges a section by strength over stress. The ratio is 1 for the ice at the load where the stress is largest.
  void judge(double at, double stress, double share) {
    if (stress <= 0) return;
    const Vec2 x = fan_.apex + at * fan_.radius * direction_;
    const double local = ice_.flexural_strength ? ice_.flexural_strength(x) / strength_ : 1;
    const double bears = share * local / stress;
    if (bears < least_) least_ = bears, place_ = at;
  }
  double least() const { return least_; }
  double radius() const { return place_ * fan_.radius; }

 private:
  const WedgeFan& fan_;
  Vec2 direction_;
  double strength_;
  const LocalIce& ice_;
  double least_ = std::numeric_limits<double>::infinity(), place_ = 1;
};

}  // namespace

WeakestSections weakest_sections(const WedgeFan& fan, double a_over_l, double flexural_strength, const LocalIce& ice) {
  NILAS_DEMAND(flexural_strength > 0);
  std::vector<double> places;
  for (int i = 0; i < k_samples; ++i) places.push_back(k_first + i * (k_last - k_first) / (k_samples - 1));
  const std::vector<double> stresses = wedge_curvatures(TipLoad::pressure, a_over_l, places);
  WeakestSections sections{0, {}};
  for (int k = 0; k <= 2 * fan.wedges; ++k) {
    Ray ray(fan, k, flexural_strength, ice);
    ray.judge(1, 1, 1);
    for (std::size_t i = 0; i < places.size(); ++i) ray.judge(places[i], stresses[i], 1);
    const auto lines = ray.lines();
    if (!lines.empty()) {
      std::vector<double> crossed;
      for (const auto& line : lines) crossed.push_back(line.first);
      const std::vector<double> there = wedge_curvatures(TipLoad::pressure, a_over_l, crossed);
      for (std::size_t i = 0; i < lines.size(); ++i) ray.judge(lines[i].first, there[i], lines[i].second);
    }
    if (k % 2 == 1) sections.strength += ray.least() / fan.wedges;
    sections.radii.push_back(ray.radius());
  }
  return sections;
}

}  // namespace nilas::fracture
