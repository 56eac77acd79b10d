#include "apps/compare/scenes/judge/loads.h"

#include <algorithm>
#include <cmath>

namespace nilas::compare {

namespace {

const RunRow* first_done(const RunTable& rows, int realisation) {
  for (const auto& row : rows)
    if (row.run.realisation == realisation && row.result.done()) return &row;
  return nullptr;
}

std::optional<output::LoadSpan> window_of(const Plan& plan, const RunTable& rows, int realisation) {
  const RunRow* row = judge_of(rows, realisation);
  if (row == nullptr) row = done_run(rows, RunKind::grid, 0, realisation);
  if (row == nullptr) row = first_done(rows, realisation);
  if (row == nullptr) return std::nullopt;
  if (!row->result.summary.window) return std::nullopt;
  output::LoadSpan span = *row->result.summary.window;
  span.to = std::min(span.to, plan.end);  // runs that began before the plan was shortened are longer
  if (!(span.to > span.from)) return std::nullopt;
  span.from = plan.coarsest_end(span.from);
  return span;
}

}  // namespace

std::vector<std::optional<output::LoadSpan>> windows_of(const Plan& plan, const RunTable& rows,
                                                        const std::string& headline) {
  std::vector<std::optional<output::LoadSpan>> windows;
  for (int r = 0; r < plan.realisations && !headline.empty(); ++r) windows.push_back(window_of(plan, rows, r));
  return windows;
}

RunTable with_loads(const Plan& plan, const std::vector<std::optional<output::LoadSpan>>& windows,
                    const std::filesystem::path& folder, RunTable rows) {
  for (auto& row : rows) {
    const auto r = static_cast<std::size_t>(row.run.realisation);
    if (r >= windows.size() || !windows[r] || !row.result.done()) continue;
    const LoadSeries series = read_load_series(folder / "runs" / row.run.id, plan.start);
    if (series.end.empty()) continue;
    auto& loads = row.loads.emplace();
    for (std::size_t c = 0; c < loads.size(); ++c)
      loads[c] = statistics_over(series, c, windows[r]->from, windows[r]->to);
  }
  return rows;
}

RunTable with_load_differences(const Plan& plan, const std::string& headline, RunTable rows) {
  for (int r = 0; r < plan.realisations && !headline.empty(); ++r) {
    const RunRow *first = done_run(rows, RunKind::grid, 0, r), *judge = judge_of(rows, r);
    for (auto& row : rows) {
      if (row.run.realisation != r || !row.result.done()) continue;
      const double load = mean_load(row, headline);
      if (first != nullptr && &row != first) row.own_difference = load - mean_load(*first, headline);
      if (judge != nullptr && !row.judges) row.load_difference = load - mean_load(*judge, headline);
    }
  }
  return rows;
}

JudgingLoads reference_loads(const RunTable& rows, const std::string& headline, const std::vector<int>& shared) {
  if (headline.empty()) return {};
  std::vector<double> mean, std, max, p99;
  for (const auto& row : rows) {
    if (!row.judges || std::find(shared.begin(), shared.end(), row.run.realisation) == shared.end()) continue;
    const output::LoadStatistics& load = load_statistics_of(row, headline);
    mean.push_back(load.mean);
    std.push_back(load.std);
    max.push_back(load.max);
    p99.push_back(load.p99);
  }
  return {estimate_of(mean), estimate_of(std), estimate_of(max), estimate_of(p99)};
}

}  // namespace nilas::compare
