#include "apps/compare/scenes/judge/pairing.h"

#include <algorithm>
#include <cmath>

namespace nilas::compare {

namespace {

double limit_of(const Findings& found, const std::vector<std::size_t>& alike, int realisation) {
  std::vector<double> loads;
  for (const std::size_t setting : alike)
    if (const RunRow* row = done_run(found.rows, RunKind::grid, setting, realisation))
      loads.push_back(mean_load(*row, found.headline));
  return chance_limit(perturbed_difference(found.rows, found.headline, realisation), loads);
}

/// The paired difference of a setting. `other`: returns the run of a realisation to compare with, or null.
template <class Other>
PairedDifference difference(const Findings& found, const Merit& merit, const std::vector<double>& limits,
                            const Other& other, bool one_for_all = false) {
  std::vector<int> realisations;
  std::vector<double> values, limits_of_these;
  for (const int r : merit.realisations) {
    const RunRow *row = done_run(found.rows, RunKind::grid, merit.setting, r), *other_run = other(r);
    if (row == nullptr || other_run == nullptr) continue;
    const double value = mean_load(*row, found.headline) - mean_load(*other_run, found.headline);
    if (std::isnan(value)) continue;
    realisations.push_back(r);
    values.push_back(value);
    limits_of_these.push_back(limits[r]);
  }
  return paired_difference(realisations, values, limits_of_these, k_rounding_share * found.measure.scale, one_for_all);
}

}  // namespace

std::optional<double> perturbed_difference(const RunTable& rows, const std::string& headline, int realisation) {
  const RunRow* first = done_run(rows, RunKind::grid, 0, realisation);
  const RunRow* perturbed = done_run(rows, RunKind::twin, 0, realisation);
  if (first == nullptr || perturbed == nullptr) return std::nullopt;
  return mean_load(*first, headline) - mean_load(*perturbed, headline);
}

double widest_limit(const std::vector<Merit>& merits, PairedDifference Merit::*member) {
  double widest = 0;
  for (const auto& m : merits)
    for (const double limit : (m.*member).limits)
      if (std::isfinite(limit)) widest = std::max(widest, limit);
  return widest;
}

std::vector<std::size_t> alike_settings(const Plan& plan) {
  const CompareSetting& own = plan.settings.front();
  const double loosest = own.tolerance > 0 ? own.tolerance : k_usual_tolerance;
  std::vector<std::size_t> alike;
  for (std::size_t s = 0; s < plan.settings.size(); ++s) {
    const CompareSetting& other = plan.settings[s];
    if (other.tolerance > 0 && other.tolerance <= loosest && other.law == own.law && other.step == own.step &&
        other.integrator == own.integrator && other.stabilisation == own.stabilisation &&
        other.simplifications == own.simplifications)
      alike.push_back(s);
  }
  return alike;
}

std::vector<Merit> with_paired_differences(const Plan& plan, const Findings& found) {
  const auto alike = alike_settings(plan);
  std::vector<double> limits;
  for (int r = 0; r < plan.realisations; ++r) limits.push_back(limit_of(found, alike, r));
  std::vector<Merit> merits = found.merits;
  for (auto& m : merits) {
    if (!m.judges)
      m.from_reference = difference(
          found, m, limits, [&](int r) { return judge_of(found.rows, r); }, found.judges.one_run);
    if (m.setting != 0)
      m.from_own = difference(found, m, limits, [&](int r) { return done_run(found.rows, RunKind::grid, 0, r); });
  }
  return merits;
}

}  // namespace nilas::compare
