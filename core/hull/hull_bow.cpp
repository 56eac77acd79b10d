#include "core/hull/hull_bow.h"

#include <algorithm>
#include <cmath>

namespace nilas::hull {

namespace {

/// Fullness 0.5 and more: the tangents around drop = t^2 / (2 ramp) for t < ramp, then a straight entrance.
std::vector<BowPoint> parabola_and_line(double fullness, int edges) {
  const double ramp = 2 * (1 - fullness);
  const int straight = std::clamp(static_cast<int>(std::lround(edges * (1 - ramp))), 1, edges);
  const int tangents = edges - straight + 1;
  std::vector<BowPoint> points;
  for (int k = 1; k <= tangents; ++k)
    points.push_back({ramp * (k - 0.5) / tangents, 0.5 * ramp * k * (k - 1) / (tangents * tangents)});
  const double start = points.back().t;
  for (int k = 1; k <= straight; ++k) {
    const double t = start + (1 - start) * k / straight;
    points.push_back({t, t - 0.5 * ramp});
  }
  return points;
}

/// Where the curve's tangent stands at share `k` of the way: half by its turn, half by its length, so that neither the
/// sharp end nor the straight end of the curve is cut coarsely.
double tangent_place(double power, double stem_slope, double k) {
  constexpr int k_halvings = 60;
  const auto way = [&](double t) {
    const double turn = std::atan(stem_slope * std::pow(t, power - 1)) / std::atan(stem_slope);
    const double length = (t + stem_slope / power * std::pow(t, power)) / (1 + stem_slope / power);
    return 0.5 * (turn + length);
  };
  double low = 0, high = 1;
  for (int i = 0; i < k_halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (way(middle) < k ? low : high) = middle;
  }
  return k < 1 ? high : 1;
}

/// Fullness below 0.5: the polygon of tangents around drop = t^power / power; its first and last edges have the
/// directions of the side and of the entrance exactly.
std::vector<BowPoint> power_curve(double fullness, double stem_slope, int edges) {
  const double power = 1 / fullness;
  std::vector<BowPoint> points;
  double t0 = 0, slope0 = 0, drop0 = 0;
  for (int k = 1; k <= edges; ++k) {
    const double t1 = tangent_place(power, stem_slope, static_cast<double>(k) / edges);
    const double slope1 = std::pow(t1, power - 1), drop1 = slope1 * t1 / power;
    const double t = (drop0 - drop1 + slope1 * t1 - slope0 * t0) / (slope1 - slope0);
    points.push_back({t, drop0 + slope0 * (t - t0)});
    t0 = t1;
    slope0 = slope1;
    drop0 = drop1;
  }
  points.push_back({1, fullness});
  return points;
}

}  // namespace

double bow_fullness(const HullForm& form) {
  return 0.5 * form.beam / (form.bow_length * std::tan(form.entrance_angle));
}

std::vector<BowPoint> bow_points(const HullForm& form, int edges) {
  if (form.kind == HullKind::wedge) return parabola_and_line(1, edges);
  const double fullness = bow_fullness(form);
  constexpr double k_parabola = 0.5;
  return fullness >= k_parabola ? parabola_and_line(fullness, edges)
                                : power_curve(fullness, std::tan(form.entrance_angle), edges);
}

}  // namespace nilas::hull
