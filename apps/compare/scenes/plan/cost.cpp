#include "apps/compare/scenes/plan/cost.h"

#include <algorithm>
#include <cmath>

#include "core/choices/solver_name.h"

namespace nilas::compare {

namespace {

/// The factor by which each decade of accuracy raises the time, approximately.
constexpr double k_per_decade = 2.5;

double tolerance_weight(double tolerance) {
  return tolerance > 0 ? std::pow(k_per_decade, std::log10(k_usual_tolerance / tolerance)) : 1;
}

/// The cost of the solver that `auto` falls back on for ccp, measured in presawn-a.xml and towing.xml.
double law_weight(const CompareSetting& setting) {
  constexpr double k_convex = 8;
  return setting.solver == "auto" && setting.law == "ccp" ? k_convex : 1;
}

double weight(const CompareSetting& setting) {
  return facts_of(choice_named<SolverName>(setting.solver)).relative_time * law_weight(setting) *
         tolerance_weight(setting.tolerance);
}

}  // namespace

double CostModel::steps_seconds(double length, double weight) const {
  double sum = 0, before = 0, last = 0;
  for (const Stretch& stretch : rate) {
    const double lasts = std::min(stretch.until, length) - before;
    if (lasts <= 0) break;
    last = stretch.other + weight * stretch.solver;
    sum += lasts * last;
    before += lasts;
  }
  return sum + std::max(0.0, length - before) * last;
}

double CostModel::reference_weight(double tolerance) const {
  if (reference.empty()) return 1;
  if (tolerance <= reference.front().tolerance) return reference.front().weight;
  for (std::size_t k = 1; k < reference.size(); ++k) {
    const Tightness &a = reference[k - 1], &b = reference[k];
    if (tolerance > b.tolerance) continue;
    const double share = std::log(tolerance / a.tolerance) / std::log(b.tolerance / a.tolerance);
    return a.weight * std::pow(b.weight / a.weight, share);
  }
  return reference.back().weight;
}

double loosest_reference(double tolerance) {
  constexpr double k_tighter = 0.1;
  return k_tighter * tolerance;
}

std::vector<double> measured_tolerances(double asked, bool fixed, const CompareSetting& own) {
  std::vector<double> tolerances{asked};
  const double loosest = loosest_reference(own.tolerance > 0 ? own.tolerance : k_usual_tolerance);
  if (!fixed && loosest > asked) tolerances.push_back(loosest);
  return tolerances;
}

double solver_weight(const CompareSetting& setting, const CompareSetting& first) {
  return weight(setting) / weight(first);
}

}  // namespace nilas::compare
