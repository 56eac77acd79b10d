/// The further results of a comparison in words.
#include <fmt/format.h>

#include <cmath>

#include "apps/compare/scenes/report/answer.h"
#include "apps/compare/scenes/report/paired_text.h"
#include "core/output/loads/step_dependence.h"
#include "core/output/loads/step_load.h"

namespace nilas::compare {

namespace {

/// The ice over which means are taken.
std::string such_ice(const Findings& found) { return found.same_ice ? "this ice" : "ice of this kind"; }

/// Warns of single steps of a setting whose load is far off, whatever its mean is.
void say_step_loads(const Merit& m, const std::string& name, std::vector<std::string>& lines) {
  if (!(m.step_load_p95 > output::StepLoadError::k_trusted)) return;
  lines.push_back(
      fmt::format("Do not use single steps and raw peaks of {}: by a second, strict solution the load of one step is "
                  "off by {} in the median and by {} in the 95th percentile. Its residual of {:.1e} m/s does not show "
                  "this.",
                  name, percent_text(m.step_load_median), percent_text(m.step_load_p95), m.law_map_m_s));
}

/// States the accuracy of the peaks, because ships are designed for the peaks of a load, and what to use instead.
void say_peaks(const SceneReport& report, std::vector<std::string>& lines) {
  const Findings& found = report.found;
  const Merit& m = found.merits[*found.choice.chosen];
  if (!found.measure.is_load() || !(found.reference.std.mean > 0) || !(found.reference.p99.mean > 0)) return;
  const auto change = [](const Estimate& of, const Estimate& reference) {
    return fmt::format("{:+.2g} %", 100 * (of.mean / reference.mean - 1));
  };
  const std::string name = report.quoted_label(m.setting);
  lines.emplace_back(
      "The recommendation holds for the mean load, not for peaks. The largest load here is the mean over a single time "
      "step. A rigid impact is over within one step, so that a shorter step gives a larger load.");
  say_step_loads(m, name, lines);
  lines.push_back(
      fmt::format("With {}, over {}, the standard deviation of the load differs by {} from the reference's, the 99 % "
                  "load by {}, and the largest load by {}.",
                  name, window_text(report), change(m.load_std, found.reference.std),
                  change(m.load_p99, found.reference.p99), change(m.load_max, found.reference.max)));
  const auto is_close = [](const Estimate& of, const Estimate& reference) {
    return std::abs(of.mean / reference.mean - 1) < output::StepDependence::k_converged;
  };
  const bool p99 = is_close(m.load_p99, found.reference.p99), largest = is_close(m.load_max, found.reference.max);
  lines.push_back(fmt::format("At {:.0f} % as the bound, {} of this setting may be used{}.",
                              100 * output::StepDependence::k_converged,
                              p99 && largest ? "the 99 % load and the largest load"
                              : p99          ? "the 99 % load"
                              : largest      ? "the largest load"
                                             : "neither the 99 % load nor the largest load",
                              p99 == largest ? ""
                              : p99          ? ", the largest load not"
                                             : ", the 99 % load not"));
  lines.push_back(fmt::format(
      "For a peak, run {} with nilas run for several seeds and quote the filtered peak that it prints, or take their "
      "peaks together by nilas statistics.",
      name));
}

/// How often the estimated error of a run's load, which `what` names, was as large as the error that was measured.
std::string coverage_text(const std::string& what, const Coverage& coverage) {
  return fmt::format(
      "{} was at least as large as the measured error in {} of {} run{}. In half of them it was more "
      "than {:.2g} times the measured error.",
      what, std::lround(coverage.share * coverage.runs), coverage.runs, coverage.runs == 1 ? "" : "s", coverage.width);
}

/// The setting with the largest significant error that the reference can show; null if there is none.
const Merit* worst_of(const Findings& found) {
  const Merit* worst = nullptr;
  for (const auto& m : found.merits)
    if (m.significant && m.error >= found.check.moves.value_or(0) && (worst == nullptr || m.error > worst->error))
      worst = &m;
  return worst;
}

void say_errors(const SceneReport& report, std::vector<std::string>& lines) {
  const Findings& found = report.found;
  if (const Merit* worst = worst_of(found))
    lines.push_back(
        fmt::format("The largest significant error{} is that of {}: {} ({}).",
                    found.measure.is_load() ? fmt::format(" of the mean ice load over {}", window_text(report)) : "",
                    report.quoted_label(worst->setting), quantity_text(worst->error, found.measure.unit),
                    percent_text(worst->error / found.measure.scale)));
  else if (std::isfinite(found.common_floor))
    lines.push_back(
        fmt::format("No setting has a significant error over {}. All errors may be chance, rounding or the "
                    "reference's own change with its step.",
                    such_ice(found)));
  if (!found.measure.is_load()) return;
  for (const auto& line : difference_lines(found, &Merit::from_reference, "the reference", report.labels()))
    lines.push_back(line);
  // if the own setting is as accurate as the reference, differences from it repeat the lines above
  const PairedDifference& off = found.merits.front().from_reference;
  const bool as_good = off.certainty != Certainty::unknown && std::abs(off.mean) <= k_target * found.measure.scale;
  if (as_good || found.merits.front().judges) return;
  for (const auto& line : difference_lines(found, &Merit::from_own, "the scene's own setting", report.labels()))
    lines.push_back(line);
}

}  // namespace

std::vector<std::string> detail_lines(const SceneReport& report) {
  const Findings& found = report.found;
  std::vector<std::string> lines;
  if (!report.compared()) return lines;
  if (!report.study.ablation && found.merits.front().done > 0) {
    if (found.choice.chosen) say_peaks(report, lines);
    say_errors(report, lines);
  }
  if (found.horizon.ends)
    lines.push_back(fmt::format(
        "The motions of single bodies can be predicted until {} s of {} s. From then on two runs that begin "
        "1e-12 m apart differ by more than {}.{}",
        moment_text(found.horizon.until_s), moment_text(report.study.plan.end),
        quantity_text(found.horizon.threshold_m, "m"),
        found.measure.is_load() && found.shared.size() > 1 ? " The effect of chance on mean loads is measured "
                                                             "separately, from realisations whose ice differs from "
                                                             "the start."
                                                           : ""));
  if (found.coverage) {
    lines.push_back(coverage_text("The error of a run's mean load that is estimated from all runs", *found.coverage));
    lines.push_back(coverage_text("The +- that a run prints by itself", *found.coverage_alone));
  }
  for (const auto& order : found.orders)
    lines.push_back(fmt::format(
        "Over {} steps the error of \"{}\" {}.", order.steps, order.rest,
        order.order > 0 ? fmt::format("falls with order {:.2f}", order.order) : "does not fall with the step"));
  return lines;
}

}  // namespace nilas::compare
