#include "apps/compare/scenes/judge/row_loads.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nilas {

namespace {

const RunRow* any_done(const Findings& found, int realisation) {
  for (const auto& row : found.rows)
    if (row.run.realisation == realisation && row.result.done()) return &row;
  return nullptr;
}

std::optional<LoadSpan> span_of(const Plan& plan, const Findings& found, int realisation) {
  const RunRow* row = reference_of(found, realisation);
  if (row == nullptr) row = done_run(found, RunKind::grid, 0, realisation);
  if (row == nullptr) row = any_done(found, realisation);
  if (row == nullptr) return std::nullopt;
  LoadSpan span{row->result.number("/window/from_s"), row->result.number("/window/to_s"),
                row->result.summary.value(nlohmann::ordered_json::json_pointer("/window/reason"), std::string())};
  span.to = std::min(span.to, plan.end);  // runs that began before the plan was cut go on longer
  if (!(span.to > span.from)) return std::nullopt;
  double coarsest = 0;
  for (const auto& setting : plan.settings) coarsest = std::max(coarsest, setting.step);
  constexpr double k_rounding = 1e-6;  // of a step
  const double steps = std::floor((span.from - plan.start) / coarsest + k_rounding);
  span.from = plan.start + steps * coarsest;
  return span;
}

}  // namespace

void measure_row_loads(const Plan& plan, const std::filesystem::path& folder, Findings& found) {
  for (int r = 0; r < plan.realisations; ++r) {
    found.windows.push_back(span_of(plan, found, r));
    const std::optional<LoadSpan>& span = found.windows.back();
    if (!span) continue;
    for (auto& row : found.rows) {
      if (row.run.realisation != r || !row.result.done()) continue;
      const LoadSeries series = read_load_series(folder / "runs" / row.run.id, plan.start);
      if (series.end.empty()) continue;
      auto& loads = row.loads.emplace();
      for (std::size_t c = 0; c < loads.size(); ++c) loads[c] = statistics_over(series, c, span->from, span->to);
    }
  }
}

double load_statistic(const RunRow& row, const std::string& channel, const std::string& statistic) {
  const auto place = std::find(k_course_channels.begin(), k_course_channels.end(), channel);
  if (place == k_course_channels.end() || !row.loads) return row.result.number("/loads/" + channel + "/" + statistic);
  const LoadStatistics& s = (*row.loads)[static_cast<std::size_t>(place - k_course_channels.begin())];
  if (statistic == "mean") return s.mean;
  if (statistic == "std") return s.std;
  return statistic == "max" ? s.max : s.p99;
}

}  // namespace nilas
