#include "fracture/bend/wedge.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/math.h"

namespace nilas::fracture {

namespace {

constexpr int k_intervals = 200;

/// The argument (a/l)^(1/3) of the tables.
double argument(double a_over_l) {
  NILAS_DEMAND(a_over_l >= 0);
  return std::cbrt(std::min(a_over_l, k_longest_tip_load));
}

}  // namespace

WedgeTable::WedgeTable(TipLoad load) {
  const auto spline = [load](double first_slope, const auto& value) {
    const auto at = [&](double t) { return value(solve_wedge(load, std::min(t * t * t, k_longest_tip_load))); };
    return tabulate(at, 0, std::cbrt(k_longest_tip_load), k_intervals, first_slope);
  };
  // Behind a short load, whose centroid is at c a, w'' = 1 - c a / x - w(0) x^2 / 6.
  const double centroid = load == TipLoad::pressure ? 2.0 / 3 : 0.5;
  const double first_rise = std::cbrt(3 * centroid / solve_wedge(load, 0).tip_deflection);
  load_factor_ = spline(0, [](const WedgeResponse& response) { return 1 / response.curvature; });
  breaking_length_ = spline(first_rise, [](const WedgeResponse& response) { return response.x_max; });
  tip_deflection_ = spline(0, [](const WedgeResponse& response) { return response.tip_deflection; });
}

double WedgeTable::load_factor(double a_over_l) const { return load_factor_(argument(a_over_l)); }
double WedgeTable::breaking_length(double a_over_l) const { return breaking_length_(argument(a_over_l)); }
double WedgeTable::tip_deflection(double a_over_l) const { return tip_deflection_(argument(a_over_l)); }

double wedge_failure_load(const WedgeTable& table, double a_over_l, double angle, double thickness,
                          double flexural_strength) {
  NILAS_DEMAND(angle > 0 && angle < k_pi);
  NILAS_DEMAND(thickness > 0 && flexural_strength > 0);
  const double b0 = 2 * std::tan(0.5 * angle);
  return b0 * flexural_strength * thickness * thickness * table.load_factor(a_over_l) / 6;
}

double wedges_failure_load(const WedgeTable& table, double a_over_l, double angle, int count, double thickness,
                           double flexural_strength) {
  NILAS_DEMAND(count > 0);
  return count * wedge_failure_load(table, a_over_l, angle, thickness, flexural_strength);
}

double bending_radius(const WedgeTable& table, double a_over_l, double l, double speed, const SpeedRule& rule) {
  NILAS_DEMAND(l > 0 && speed >= 0);
  return table.breaking_length(a_over_l) * l * std::max(1 + rule.slope * speed, rule.least);
}

}  // namespace nilas::fracture
