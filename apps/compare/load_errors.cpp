#include "apps/compare/load_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/compare/statistics.h"

namespace nilas {

namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

/// Of first order: the difference of a step and its half is what the half is off, twice that the whole. By the
/// setting's own steps, or the first setting's: what a step does has little to do with who solves it.
double step_part(const Plan& plan, const Findings& found, std::size_t setting) {
  constexpr double k_same = 1e-9;
  const auto difference = [&](const CompareSetting& family, double step) {
    for (const auto& m : found.merits) {
      CompareSetting other = plan.settings[m.setting];
      if (std::abs(other.step - step) > k_same * step || m.done == 0) continue;
      other.step = family.step;
      if (other == family) return m.load_difference.mean;
    }
    return k_nan;
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
  return k_nan;
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

void judge_load_errors(const Plan& plan, double chaos, Findings& found) {
  std::vector<double> measured, alone, all;
  const std::string channel = "/load_error/channels/" + found.headline;
  for (auto& row : found.rows) {
    if (row.run.kind != RunKind::grid || !row.load_difference) continue;
    LoadErrorParts parts;
    parts.alone = row.result.number(channel + "/estimate");
    parts.solver = row.result.number(channel + "/solver");
    parts.law = row.result.number(channel + "/law");
    parts.chaos = chaos;
    parts.step = step_part(plan, found, row.run.setting);
    if (std::isnan(parts.alone) || std::isnan(parts.solver)) continue;
    row.load_error = parts;
    measured.push_back(std::abs(*row.load_difference));
    alone.push_back(parts.alone);
    all.push_back(parts.total());
  }
  if (measured.empty()) return;
  found.coverage = coverage(all, measured, k_rounding_share * found.scale);
  found.coverage_alone = coverage(alone, measured, k_rounding_share * found.scale);
}

}  // namespace nilas
