#include "core/output/loads/step_dependence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/output/loads/load_statistics.h"
#include "core/output/loads/peak.h"

namespace nilas::output {

namespace {

/// By how much `second` is smaller than `first` in absolute value, as a share of it; 0 where it is not.
double fall(double first, double second) {
  return first == 0 ? 0 : std::max(0.0, 1 - std::abs(second) / std::abs(first));
}

std::string listed(const std::vector<std::string>& words, const char* last) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k)
    text += (k == 0 ? "" : k + 1 == words.size() ? fmt::format(" {} ", last) : ", ") + words[k];
  return text;
}

}  // namespace

StepDependence step_dependence(const std::vector<double>& series, double h, double filter, bool rigid) {
  StepDependence found{.rigid = rigid};
  std::vector<double> pairs(series.size() / 2);
  if (pairs.empty()) return found;
  for (std::size_t k = 0; k < pairs.size(); ++k) pairs[k] = 0.5 * (series[2 * k] + series[2 * k + 1]);
  const double width = std::max(filter, 2 * h);  // A pair of steps is the least over which pairs have means.
  const double filtered_of_pairs = peak_of(pairs, 0, 2 * h, width).filtered;
  if (series.size() % 2 == 1) pairs.push_back(series.back());  // so that a peak in the last step is no fall
  const LoadStatistics single = load_statistics(series), paired = load_statistics(pairs);
  found.p99 = fall(single.p99, paired.p99);
  found.raw = fall(single.max, paired.max);
  found.filtered = fall(peak_of(series, 0, h, filter).filtered, filtered_of_pairs);
  return found;
}

std::string figures_to_use(const StepDependence& dependence, bool at_least) {
  std::vector<std::string> good{at_least ? "the mean (its +- is a lower bound)" : "the mean with its +-"}, bad;
  const auto judge = [&](const char* name, double change, bool may_converge = true) {
    if (may_converge && change < StepDependence::k_converged)
      good.emplace_back(name);
    else
      bad.push_back(fmt::format("{} ({:.0f} %)", name, 100 * change));
  };
  judge("the filtered peak", dependence.filtered);
  judge("the 99th percentile of the steps", dependence.p99);
  // That single steps are in doubt is said with their errors, and is no matter of the time step.
  if (!dependence.doubted || dependence.rigid || dependence.raw >= StepDependence::k_converged)
    judge("the raw peak", dependence.raw, !dependence.rigid);
  std::string text = fmt::format("Use {}.", listed(good, "and"));
  if (!bad.empty())
    text += fmt::format(
        " Do not use {}: {} on the time step. The percentage is what averaging the steps in pairs takes off.",
        listed(bad, "or"), bad.size() == 1 ? "it depends" : "they depend");
  return text + " A peak is one draw: run several seeds, and see `nilas statistics`.";
}

}  // namespace nilas::output
