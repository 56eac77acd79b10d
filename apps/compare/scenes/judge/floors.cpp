#include "apps/compare/scenes/judge/floors.h"

#include <algorithm>
#include <cmath>

#include "apps/compare/scenes/judge/merits.h"
#include "apps/compare/scenes/judge/pairing.h"
#include "apps/compare/workshop/special_numbers.h"
#include "core/base/statistics.h"

namespace nilas::compare {

namespace {

/// The largest number of realisations that a setting has. It may be below the planned number.
int most_realisations(const std::vector<Merit>& merits) {
  int most = 1;
  for (const auto& m : merits) most = std::max(most, m.load_difference.count);
  return most;
}

/// The differences of the mean loads of the first setting and its perturbed runs, one per realisation [N].
std::vector<double> perturbed_differences(const Plan& plan, const RunTable& rows, const std::string& headline) {
  std::vector<double> differences;
  for (int r = 0; r < plan.realisations; ++r)
    if (const auto difference = perturbed_difference(rows, headline, r)) differences.push_back(*difference);
  return differences;
}

/// The variance of the difference of a setting from the reference in one realisation [N^2].
double own_variance(const Merit& m) {
  return m.load_difference.standard_error * m.load_difference.standard_error * m.load_difference.count;
}

/// The variance of the runs and that of the reference [N^2]. The latter is for one run that judges all realisations,
/// because its chance does not average out.
struct VarianceParts {
  double runs, reference;
};
VarianceParts variance_parts(const Chance& chance, const Judges& judges) {
  const double reference = judges.one_run ? 0.5 * chance.variance.value : 0;
  return {chance.variance.value - reference, reference};
}

}  // namespace

double floor_of(double variance, double degrees, int realisations, double reference) {
  if (!(degrees > 0)) return k_infinity;
  return student_95(degrees) * std::sqrt(variance / std::max(1, realisations) + reference);
}

Chance chance_of(const Plan& plan, const RunTable& rows, const Judges& judges, const std::vector<int>& shared,
                 const std::string& headline, const Measure& measure, const std::vector<Merit>& merits) {
  if (!measure.is_load()) return {{}, 0, k_unknown};
  const int most = most_realisations(merits);
  std::vector<std::vector<double>> settings;
  for (const auto& m : merits)
    if (m.load_difference.count == most && !m.judges)
      settings.push_back(over_runs(rows, m.setting, shared, [](const RunRow& row) { return row.load_difference; }));
  if (judges.one_run && settings.size() == 1) settings.clear();  // it scatters as one run does, not as a difference
  const PooledVariance pooled = pooled_variance(perturbed_differences(plan, rows, headline), settings);
  if (!(pooled.degrees > 0)) return {pooled, k_unknown, k_unknown};
  return {pooled, std::sqrt(0.5 * pooled.value), student_95(pooled.degrees) * std::sqrt(pooled.value)};
}

double common_floor(const std::vector<Merit>& merits, const Judges& judges, const Measure& measure,
                    const Chance& chance, const Horizon& horizon) {
  if (!measure.is_load())
    return !horizon.known ? k_infinity : horizon.ends ? horizon.threshold_m : k_rounding_share * measure.scale;
  const VarianceParts parts = variance_parts(chance, judges);
  return floor_of(parts.runs, chance.variance.degrees, most_realisations(merits), parts.reference) +
         k_rounding_share * measure.scale;
}

std::vector<Merit> with_floors(std::vector<Merit> merits, const Judges& judges, const Measure& measure,
                               const Chance& chance, double common) {
  const VarianceParts parts = variance_parts(chance, judges);
  const double degrees = chance.variance.degrees;
  for (auto& m : merits) {
    m.floor = common;
    if (measure.is_load()) {
      const int count = m.load_difference.count;
      const double own = own_variance(m);
      const bool wild = !std::isnan(own) && own > fisher_95(count - 1, degrees) * parts.runs;
      m.floor = floor_of(wild ? own : parts.runs, wild ? count - 1 : degrees, count, parts.reference) +
                k_rounding_share * measure.scale;
      if (m.done == 0) m.floor = k_unknown;
    }
    m.significant = m.error > m.floor;
  }
  return merits;
}

StepCheck step_check(const RunTable& rows, const Judges& judges, const Measure& measure, const Chance& chance,
                     const std::vector<Merit>& merits) {
  StepCheck check;
  for (const auto& row : rows)
    if (row.run.kind == RunKind::check && row.result.done() && judges.stand_in.empty())
      if (const auto moves = measured_error(row, measure)) check.moves = std::abs(*moves);
  if (!check.moves) return check;
  if (measure.is_load() && !std::isnan(chance.run_N)) check.chance = 2 * std::sqrt(2.0) * chance.run_N;
  check.coarse = *check.moves > check.chance && std::any_of(merits.begin(), merits.end(), [&](const Merit& m) {
    return m.significant && m.error < *check.moves;
  });
  return check;
}

}  // namespace nilas::compare
