#include "apps/report/page/mooring_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/report/figures/thin.h"
#include "apps/report/page/words.h"

namespace nilas::report {

namespace {

constexpr std::size_t k_most_lines = 8, k_points = 500;

struct LineTension {
  std::string name;
  const std::vector<double>* series = nullptr;  ///< [N]
  std::size_t step = 0;                         ///< of the largest tension
  double largest = -std::numeric_limits<double>::infinity();
};

std::vector<LineTension> tensions_of(const RunTable& steps) {
  const std::string begin = "line_", end = "_tension_N";
  std::vector<LineTension> lines;
  for (const std::string& column : steps.names()) {
    if (!column.starts_with(begin) || !column.ends_with(end) || column.size() <= begin.size() + end.size()) continue;
    LineTension line{.name = column.substr(begin.size(), column.size() - begin.size() - end.size()),
                     .series = &steps[column]};
    for (std::size_t k = 0; k < line.series->size(); ++k) {
      const double value = (*line.series)[k];
      if (!(value > line.largest)) continue;
      line.largest = value;
      line.step = k;
    }
    if (std::isfinite(line.largest)) lines.push_back(line);
  }
  std::stable_sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) { return a.largest > b.largest; });
  return lines;
}

/// The mean of lines at each point, with their least and largest tension as range.
Curve curve_of_others(const std::vector<LineTension>& lines, const std::vector<double>& time, double factor) {
  Curve all;
  for (std::size_t k = k_most_lines; k < lines.size(); ++k) {
    const Curve one = thinned("", time, *lines[k].series, factor, k_points);
    const std::vector<double>&low = one.low.empty() ? one.y : one.low, &high = one.high.empty() ? one.y : one.high;
    if (all.x.empty()) {
      all = {.x = one.x, .y = std::vector<double>(one.y.size(), 0), .low = low, .high = high};
    }
    for (std::size_t i = 0; i < one.y.size(); ++i) {
      all.y[i] += one.y[i] / static_cast<double>(lines.size() - k_most_lines);
      all.low[i] = std::min(all.low[i], low[i]);
      all.high[i] = std::max(all.high[i], high[i]);
    }
  }
  all.name = fmt::format("mean and range of {} others", lines.size() - k_most_lines);
  return all;
}

}  // namespace

std::optional<MooringPlot> mooring_plot(const RunFindings& found) {
  const RunTable& steps = found.run.steps;
  const std::vector<LineTension> lines = tensions_of(steps);
  if (lines.empty()) return std::nullopt;
  const LineTension& first = lines.front();
  const output::ForceUnit unit = output::force_unit(first.largest);
  const double factor = 1 / unit.size, time = steps.time()[first.step];
  MooringPlot made;
  made.plot = {.id = "mooring-tension",
               .title = "Tension of the mooring lines",
               .x_label = "time [s]",
               .y_label = fmt::format("tension [{}]", unit.name),
               .over_time = true};
  for (std::size_t k = 0; k < std::min(lines.size(), k_most_lines); ++k)
    made.plot.curves.push_back(thinned(lines[k].name, steps.time(), *lines[k].series, factor, k_points));
  if (lines.size() > k_most_lines) made.plot.curves.push_back(curve_of_others(lines, steps.time(), factor));
  const std::string largest = output::force_text(first.largest), when = time_text(time, found.run.step());
  made.plot.curves.push_back({.name = fmt::format("largest: {} in {}", largest, first.name),
                              .x = {time},
                              .y = {first.largest * factor},
                              .is_dots = true});
  made.text =
      fmt::format("The largest tension of a mooring line was {} in line {}, at {}. ", largest, first.name, when) +
      (lines.size() > 1 ? "The legend has the lines in the order of their largest tensions." : "");
  return made;
}

}  // namespace nilas::report
