#include "apps/compare/scenes/judge/merits.h"

#include <algorithm>
#include <cmath>

#include "apps/compare/workshop/special_numbers.h"
#include "core/base/statistics.h"

namespace nilas::compare {

namespace {

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

/// The merit with the counts of the setting's runs and the realisations of its means.
Merit counted(const RunTable& rows, std::size_t setting, const std::vector<int>& shared) {
  Merit m;
  m.setting = setting;
  std::string not_done;
  for (const auto& row : rows) {
    if (!row.is_grid(setting)) continue;
    ++m.planned;
    m.done += row.result.done() ? 1 : 0;
    m.failed += row.result.failed() ? 1 : 0;
    if (row.result.done() && contains(shared, row.run.realisation)) m.realisations.push_back(row.run.realisation);
    if (row.result.failed() && m.trouble.empty())
      m.trouble = row.result.status + (row.result.cause.empty() ? "" : ": " + row.result.cause);
    if (!row.result.done() && not_done.empty()) not_done = row.result.cause;
  }
  if (m.done == 0 && m.trouble.empty()) m.trouble = not_done.empty() ? "not run" : not_done;
  m.partial = m.done > 0 && m.realisations.size() < shared.size();
  return m;
}

/// The runs of one setting, from which its figures are read.
struct SettingRuns {
  const RunTable& rows;
  std::size_t setting;
  const std::vector<int>& shared;

  std::vector<double> all(const std::function<std::optional<double>(const RunRow&)>& value) const {
    return over_runs(rows, setting, shared, value);
  }
  Estimate load(const std::string& headline, double output::LoadStatistics::*statistic) const {
    return estimate_of(all([&](const RunRow& row) { return load_statistics_of(row, headline).*statistic; }));
  }
  Estimate motion(double MotionError::*member) const {
    return estimate_of(
        all([&](const RunRow& row) { return row.motion ? std::optional((*row.motion).*member) : std::nullopt; }));
  }
  /// The largest absolute value; NaN without values.
  double worst(const std::function<std::optional<double>(const RunRow&)>& value) const {
    double most = k_unknown;
    for (const double v : all(value)) most = std::isnan(most) ? std::abs(v) : std::max(most, std::abs(v));
    return most;
  }
};

void read_accuracy(const SettingRuns& runs, Merit& m) {
  const auto summary = [](const RunRow& row) -> const output::RunSummary& { return row.result.summary; };
  m.penetration_max_m = runs.worst([&](const RunRow& row) { return summary(row).penetration_max_m; });
  m.penetration_mean_m = runs.worst([&](const RunRow& row) { return row.result.penetration_mean_m; });
  m.law_map_m_s = runs.worst([&](const RunRow& row) { return summary(row).residuals.law_map_m_s; });
  m.natural_map_m_s = runs.worst([&](const RunRow& row) { return summary(row).residuals.natural_map_m_s; });
  m.step_load_median = runs.worst([&](const RunRow& row) { return summary(row).step_load_median; });
  m.step_load_p95 = runs.worst([&](const RunRow& row) { return summary(row).step_load_p95; });
  m.energy_error = runs.worst([&](const RunRow& row) { return summary(row).imbalance_relative; });
  m.momentum_error = runs.worst([&](const RunRow& row) { return summary(row).momentum_imbalance_relative; });
  m.unconverged_share =
      runs.worst([&](const RunRow& row) { return summary(row).unconverged_steps / summary(row).steps; });
}

}  // namespace

Estimate estimate_of(const std::vector<double>& values) {
  Estimate e;
  e.count = static_cast<int>(values.size());
  e.mean = values.empty() ? k_unknown : mean_of(values);
  e.standard_error = std::sqrt(variance_of(values) / static_cast<double>(std::max<std::size_t>(values.size(), 1)));
  return e;
}

std::optional<double> measured_error(const RunRow& row, const Measure& measure) {
  if (measure.is_load()) return row.load_difference;
  if (!row.motion) return std::nullopt;
  return measure.name == "turn" ? row.motion->turn_rad : row.motion->rms_m;
}

std::vector<double> over_runs(const RunTable& rows, std::size_t setting, const std::vector<int>& shared,
                              const std::function<std::optional<double>(const RunRow&)>& value) {
  std::vector<double> values;
  for (const auto& row : rows)
    if (row.is_grid(setting) && row.result.done() && contains(shared, row.run.realisation))
      if (const std::optional<double> v = value(row); v && !std::isnan(*v)) values.push_back(*v);
  return values;
}

std::vector<Merit> merits_of(const Plan& plan, const RunTable& rows, const Judges& judges,
                             const std::vector<int>& shared, const std::string& headline, const Measure& measure) {
  std::vector<Merit> merits;
  for (std::size_t s = 0; s < plan.settings.size(); ++s) {
    Merit m = counted(rows, s, shared);
    const SettingRuns runs{rows, s, shared};
    m.load = runs.load(headline, &output::LoadStatistics::mean);
    m.load_std = runs.load(headline, &output::LoadStatistics::std);
    m.load_max = runs.load(headline, &output::LoadStatistics::max);
    m.load_p99 = runs.load(headline, &output::LoadStatistics::p99);
    m.load_difference = estimate_of(runs.all([](const RunRow& row) { return row.load_difference; }));
    m.motion = runs.motion(&MotionError::rms_m);
    m.turn = runs.motion(&MotionError::turn_rad);
    read_accuracy(runs, m);
    m.time = median_of(runs.all([](const RunRow& row) { return row.result.compute_per_second(); }));
    m.ms_per_step = median_of(runs.all([](const RunRow& row) { return row.result.ms_per_step(); }));
    const auto errors = runs.all([&](const RunRow& row) { return measured_error(row, measure); });
    m.judges = judges.setting == s;
    m.error = m.judges && m.done > 0 ? 0 : errors.empty() ? k_unknown : std::abs(mean_of(errors));
    merits.push_back(m);
  }
  return merits;
}

double time_spread(const Plan& plan, const RunTable& rows) {
  std::vector<double> relative;
  for (std::size_t s = 0; s < plan.settings.size(); ++s) {
    std::vector<double> times;
    for (const auto& row : rows)
      if (row.is_grid(s) && row.result.done())
        if (const double time = row.result.compute_per_second(); !std::isnan(time)) times.push_back(time);
    if (times.size() > 1) relative.push_back(std::sqrt(variance_of(times)) / mean_of(times));
  }
  double squares = 0;
  for (const double r : relative) squares += r * r / static_cast<double>(relative.size());
  return relative.empty() ? k_unknown : std::sqrt(squares);
}

std::vector<Merit> with_time_spread(std::vector<Merit> merits, double relative) {
  for (auto& m : merits) m.time_spread = relative * m.time;
  return merits;
}

}  // namespace nilas::compare
