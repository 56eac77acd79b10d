#include "apps/compare/scenes/judge/run_table.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "apps/compare/workshop/special_numbers.h"

namespace nilas::compare {

namespace {

constexpr output::LoadStatistics k_no_statistics{k_unknown, k_unknown, k_unknown, k_unknown};

}  // namespace

RunTable run_table(const Plan& plan, const std::map<std::string, RunResult>& results) {
  RunTable rows;
  for (const auto& run : plan.runs) {
    const auto found = results.find(run.id);
    rows.push_back({run, found == results.end() ? RunResult{} : found->second});
  }
  const auto place = [](const RunRow& row) { return std::tuple(row.run.kind, row.run.setting, row.run.realisation); };
  std::sort(rows.begin(), rows.end(), [&](const RunRow& a, const RunRow& b) { return place(a) < place(b); });
  return rows;
}

const RunRow* done_run(const RunTable& rows, RunKind kind, std::size_t setting, int realisation) {
  for (const auto& row : rows)
    if (row.run.kind == kind && row.run.setting == setting && row.run.realisation == realisation && row.result.done())
      return &row;
  return nullptr;
}

const RunRow* judge_of(const RunTable& rows, int realisation) {
  for (const auto& row : rows)
    if (row.judges && row.run.realisation == realisation) return &row;
  return nullptr;
}

const output::LoadStatistics& load_statistics_of(const RunRow& row, const std::string& channel) {
  const auto place = std::find(k_course_channels.begin(), k_course_channels.end(), channel);
  if (place != k_course_channels.end() && row.loads) return (*row.loads)[place - k_course_channels.begin()];
  const output::LoadStatistics* own = row.result.summary.load(channel);
  return own == nullptr ? k_no_statistics : *own;
}

double mean_load(const RunRow& row, const std::string& channel) { return load_statistics_of(row, channel).mean; }

std::string headline_of(const RunTable& rows) {
  const std::string channel = k_course_channels.front();
  const auto has_it = [&](const RunRow& row) {
    const output::LoadStatistics* load = row.result.summary.load(channel);
    return row.result.done() && load != nullptr && !std::isnan(load->mean);
  };
  return std::any_of(rows.begin(), rows.end(), has_it) ? channel : "";
}

}  // namespace nilas::compare
