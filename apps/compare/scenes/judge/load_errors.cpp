#include "apps/compare/scenes/judge/load_errors.h"

#include <algorithm>
#include <cmath>

#include "apps/compare/workshop/special_numbers.h"
#include "core/base/statistics.h"

namespace nilas::compare {

namespace {

constexpr double k_same = 1e-9;  // relative difference of two equal steps

/// The error of a first-order step [N]: the difference of a step and its half is the error of the half, and twice that
/// is the error of the whole. It is taken from the setting's own steps, else from the first setting's, because the
/// effect of a step depends little on the solver. NaN if neither was run with half or twice the step.
double family_step_part(const Plan& plan, const Findings& found, std::size_t setting) {
  const auto difference = [&](const CompareSetting& family, double step) {
    for (const auto& m : found.merits) {
      CompareSetting other = plan.settings[m.setting];
      if (std::abs(other.step - step) > k_same * step || m.done == 0) continue;
      other.step = family.step;
      if (other == family) return m.load_difference.mean;
    }
    return k_unknown;
  };
  const double h = plan.settings[setting].step;
  for (const std::size_t of : {setting, std::size_t{0}}) {
    const CompareSetting& family = plan.settings[of];
    const double own = difference(family, h);
    const double half = 2 * std::abs(own - difference(family, 0.5 * h)),
                 whole = std::abs(own - difference(family, 2 * h));
    if (!std::isnan(half)) return half;
    if (!std::isnan(whole)) return whole;
  }
  return k_unknown;
}

/// The error of the step [N]: that of the family, and for coarser steps than the reference's check at least twice the
/// change of the reference when its step is doubled.
double step_part(const Plan& plan, const Findings& found, std::size_t setting) {
  const double family = family_step_part(plan, found, setting);
  const bool coarser = plan.settings[setting].step > (1 - k_same) * plan.check.step;
  if (!found.check.moves || !coarser || *found.check.moves <= found.check.chance) return family;
  const double shown = 2 * *found.check.moves;
  return std::isnan(family) ? shown : std::max(family, shown);
}

/// Twice the standard deviation [N] of the loads of settings with the same law and step. They differ in what should not
/// matter: solver, tolerance, stabilisation, integrator. The setting itself is left out, so that the estimate does not
/// repeat what is measured, and so is the variance by chaos.
double scatter_of_kin(const Plan& plan, const Findings& found, std::size_t setting) {
  const CompareSetting& own = plan.settings[setting];
  std::vector<double> differences;
  int most = 1;
  for (const auto& m : found.merits) {
    const CompareSetting& other = plan.settings[m.setting];
    if (m.setting != setting && other.law == own.law && std::abs(other.step - own.step) < k_same * own.step &&
        m.load_difference.count > 0) {
      differences.push_back(m.load_difference.mean);
      most = std::max(most, m.load_difference.count);
    }
  }
  constexpr std::size_t k_least = 3;
  if (differences.size() < k_least) return 0;
  const double by_chance = std::isnan(found.chance.run_N) ? 0 : found.chance.run_N * found.chance.run_N / most;
  return 2 * std::sqrt(std::max(0.0, variance_of(differences) - by_chance));
}

/// The median effect of the law [N]: its difference from exact friction at other steps and tolerances.
double law_elsewhere(const Plan& plan, const Findings& found, std::size_t setting) {
  std::vector<double> shifts;
  for (const auto& m : found.merits) {
    const CompareSetting& other = plan.settings[m.setting];
    if (m.setting == setting || other.law != plan.settings[setting].law || m.load_difference.count == 0) continue;
    for (const auto& exact : found.merits) {
      const CompareSetting& like = plan.settings[exact.setting];
      if (like.law == "coulomb" && like.step == other.step && like.tolerance == other.tolerance &&
          like.stabilisation == other.stabilisation && like.integrator == other.integrator &&
          exact.load_difference.count > 0) {
        shifts.push_back(std::abs(m.load_difference.mean - exact.load_difference.mean));
        break;
      }
    }
  }
  return shifts.empty() ? 0 : median_of(shifts);
}

/// The chaos part [N], the smaller of two 95 % limits of the difference of two runs. Few perturbed runs make the one
/// too wide, and a rough course of the load the other.
double chaos_part(double of_comparison, double of_run) {
  const double of_two_runs = std::sqrt(2.0) * of_run;
  if (std::isnan(of_comparison) || std::isnan(of_run)) return std::isnan(of_run) ? of_comparison : of_two_runs;
  return std::min(of_comparison, of_two_runs);
}

}  // namespace

Coverage coverage(const std::vector<double>& estimates, const std::vector<double>& measured, double rounding) {
  Coverage c;
  c.runs = static_cast<int>(measured.size());
  std::vector<double> widths;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    c.share += estimates[k] + rounding >= measured[k] ? 1.0 / c.runs : 0;
    widths.push_back(estimates[k] / std::max(measured[k], rounding));
  }
  c.width = median_of(widths);
  return c;
}

double LoadErrorParts::total() const {
  const auto known = [](double part) { return std::isnan(part) ? 0 : part; };
  return std::hypot(known(chaos), known(solver) + known(law) + known(step));
}

/// The parts of a run's load error; nothing if the run does not state its own error.
static std::optional<LoadErrorParts> load_error_parts(const Plan& plan, const Findings& found, const RunRow& row) {
  const auto own = row.result.summary.load_errors.find(found.headline);
  if (own == row.result.summary.load_errors.end()) return std::nullopt;
  const output::LoadErrorFigures& figures = own->second;
  if (std::isnan(figures.estimate) || std::isnan(figures.solver)) return std::nullopt;
  const std::size_t setting = row.run.setting;
  LoadErrorParts parts;
  parts.alone = figures.estimate;
  parts.solver = std::max(figures.solver, scatter_of_kin(plan, found, setting));
  parts.law = figures.law;
  if (plan.settings[setting].law != "coulomb") parts.law = std::max(parts.law, law_elsewhere(plan, found, setting));
  parts.chaos = chaos_part(found.chance.difference_95_N, figures.chaos);
  parts.step = step_part(plan, found, setting);
  return parts;
}

LoadErrors load_errors(const Plan& plan, const Findings& found) {
  LoadErrors errors;
  std::vector<double> measured, alone, all;
  for (const auto& row : found.rows) {
    std::optional<LoadErrorParts>& parts = errors.of_rows.emplace_back();
    if (row.run.kind != RunKind::grid || !row.load_difference) continue;
    parts = load_error_parts(plan, found, row);
    if (!parts) continue;
    measured.push_back(std::abs(*row.load_difference));
    alone.push_back(parts->alone);
    all.push_back(parts->total());
  }
  if (measured.empty()) return errors;
  errors.coverage = coverage(all, measured, k_rounding_share * found.measure.scale);
  errors.coverage_alone = coverage(alone, measured, k_rounding_share * found.measure.scale);
  return errors;
}

}  // namespace nilas::compare
