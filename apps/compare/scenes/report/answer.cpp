#include "apps/compare/scenes/report/answer.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/compare/scenes/report/paired_text.h"

namespace nilas::compare {

namespace {

/// "6.1 times faster than", "1.3 times slower than", "about as fast as".
std::string speed_text(double ratio) {
  constexpr double k_alike = 1.05;
  if (ratio > k_alike) return fmt::format("{:.2g} times faster than", ratio);
  if (ratio < 1 / k_alike) return fmt::format("{:.2g} times slower than", 1 / ratio);
  return "about as fast as";
}

/// The ice over which means are taken.
std::string such_ice(const Findings& found) { return found.same_ice ? "this ice" : "ice of this kind"; }

/// The quantity of which errors in percent are shares.
std::string scale_text(const Findings& found) {
  if (found.measure.is_load())
    return fmt::format("the reference's mean ice load ({} along the course)",
                       quantity_text(found.reference.mean.mean, "N"));
  if (found.measure.name == "turn") return "1 rad";
  return fmt::format("the longest path of a body ({})", quantity_text(found.measure.scale, "m"));
}

/// Whether the error of a setting may be chance, and the limit of that is above the target.
bool hidden_by_chance(const Merit& m, const Findings& found) {
  return !m.significant && m.floor > k_target * found.measure.scale;
}

std::string accuracy_text(const Merit& m, const Findings& found) {
  const Measure& measure = found.measure;
  const std::string floor = quantity_text(m.floor, measure.unit), share = percent_text(m.floor / measure.scale);
  if (measure.is_load()) {
    if (hidden_by_chance(m, found))
      return fmt::format("its mean ice load cannot be distinguished from {}; differences up to {} ({}) may be chance",
                         scale_text(found), floor, share);
    return fmt::format("its mean ice load is within {} of {}", percent_text(k_target), scale_text(found));
  }
  const std::string error = measure.name == "turn" ? "error in attitude" : "error in position";
  if (hidden_by_chance(m, found))
    return fmt::format("its {} is not significant; errors up to {} may be chance", error, floor);
  return fmt::format("its {} is below {} of {}", error, percent_text(k_target), scale_text(found));
}

void say_recommendation(const SceneReport& report, std::vector<std::string>& lines) {
  const Findings& found = report.found;
  const Merit &own = found.merits.front(), &best = found.merits[*found.choice.chosen];
  const std::string own_name = full_label(report.study.plan.settings.front());
  const std::string accuracy = accuracy_text(best, found);
  if (best.setting == own.setting)
    lines.push_back(
        fmt::format("Keep the scene's own setting ({}): {}, and no other setting that is as accurate{} is "
                    "significantly faster. It takes {:.3g} s of computing per simulated second.",
                    own_name, accuracy, found.choice.deeper ? " and lets bodies penetrate no deeper" : "", own.time));
  else
    lines.push_back(fmt::format(
        "Use \"{}\": {}. It is {} the scene's own setting ({}), with {:.3g} s of computing per "
        "simulated second instead of {:.3g} s.",
        report.label(best.setting), accuracy, speed_text(own.time / best.time), own_name, best.time, own.time));
  if (!hidden_by_chance(best, found)) return;
  const std::size_t count = best.realisations.size();
  lines.push_back(
      fmt::format("By chance alone, the means over {} realisation{} of {:g} s differ by so much (95 %). Smaller "
                  "errors cannot be shown.",
                  count, count == 1 ? "" : "s", report.study.plan.end - report.study.plan.start));
}

std::string no_recommendation(const SceneReport& report) {
  const Findings& found = report.found;
  if (report.untouched())
    return fmt::format(
        "The ice did not touch the vessel in the {:g} s that were simulated. No setting is recommended; "
        "motions are compared.",
        report.study.plan.end - report.study.plan.start);
  if (!std::isfinite(found.common_floor))
    return fmt::format(
        "No setting is recommended, because the effect of chance is not known: a perturbed run{} must be "
        "done first.",
        found.measure.is_load() ? " or a second realisation" : "");
  return fmt::format("No setting is recommended: none is within {} of {}.", percent_text(k_target), scale_text(found));
}

void say_price(const SceneReport& report, std::vector<std::string>& lines) {
  const Findings& found = report.found;
  const Merit& own = found.merits.front();
  if (own.done == 0) {
    lines.emplace_back("No setting is recommended: no run of the scene's own setting is done.");
    return;
  }
  if (found.choice.chosen)
    say_recommendation(report, lines);
  else
    lines.push_back(no_recommendation(report));
  if (!found.choice.deeper) return;
  const Merit& deep = found.merits[*found.choice.deeper];
  lines.push_back(
      fmt::format("\"{}\" is as accurate and {} the scene's own setting, but lets bodies penetrate each other "
                  "by up to {} (the scene's own setting: {}).",
                  report.label(deep.setting), speed_text(own.time / deep.time),
                  quantity_text(deep.penetration_max_m, "m"), quantity_text(own.penetration_max_m, "m")));
}

/// "+1.2 N +- 0.3 N, which is significant (95 %)", or why it is not known to be.
std::string change_text(const PairedDifference& d) {
  std::string text = quantity_text(d.mean, "N") + uncertainty_text(d.mean, d.half_width, "N");
  switch (d.certainty) {
    case Certainty::everywhere:
      return text + ", which is significant (95 %)";
    case Certainty::in_realisations:
      return text + (d.realisations.size() == 1
                         ? ", which is more than chance makes in the one realisation that was run"
                         : fmt::format(", which is more than chance makes in {} of {} realisations", d.beyond_chance,
                                       d.realisations.size()));
    case Certainty::none:
      return text + ", which may be chance";
    case Certainty::unknown:
      break;
  }
  return text + "; the effect of chance is not known";
}

std::string changed_by(const Merit& m, const Findings& found) {
  if (found.measure.is_load())
    return m.load_difference.mean == 0 ? "does not change the mean ice load"
                                       : "changes the mean ice load by " + change_text(m.from_reference);
  return m.significant ? fmt::format("moves bodies by {} (rms) and turns them by {:.2g} rad",
                                     quantity_text(m.motion.mean, "m"), m.turn.mean)
                       : "does not change the motion by more than rounding or chance";
}

std::string saved_by(const Merit& m, const Merit& full, double time_spread) {
  constexpr double k_sure = 3;
  const double saved = full.time - m.time;
  const double scatter = std::isnan(time_spread) ? 0 : k_sure * std::sqrt(2.0) * time_spread * full.time;
  if (std::abs(saved) <= scatter) return "makes no significant difference in computing time";
  return fmt::format("{} {:.3g} ms of computing per simulated second ({:.3g} ms per step)",
                     saved >= 0 ? "saves" : "costs", 1e3 * std::abs(saved), std::abs(full.ms_per_step - m.ms_per_step));
}

/// The largest change comes first.
void say_ablation(const SceneReport& report, std::vector<std::string>& lines) {
  const Findings& found = report.found;
  if (report.untouched())
    lines.push_back(
        fmt::format("The ice did not touch the vessel in the {:g} s that were simulated. Motions are compared.",
                    report.study.plan.end - report.study.plan.start));
  std::vector<Merit> by_error = found.merits;
  const auto shown = [](const Merit& m) { return m.significant ? m.error : 0; };
  std::stable_sort(by_error.begin(), by_error.end(),
                   [&](const Merit& a, const Merit& b) { return shown(a) > shown(b); });
  for (const auto& m : by_error) {
    if (m.setting == 0) continue;
    const std::string name = report.label(m.setting);
    if (m.done == 0 || std::isnan(m.error))
      lines.push_back(fmt::format("\"{}\": no run is done ({}).", name, m.trouble));
    else
      lines.push_back(fmt::format("\"{}\" {}; it {}.", name, changed_by(m, found),
                                  saved_by(m, found.merits.front(), found.time_spread)));
  }
  if (by_error.size() < 2) lines.emplace_back("The budget had no time for any simplification.");
}

std::string blocked(const SceneReport& report) {
  const Findings& found = report.found;
  if (!report.trouble.empty()) return report.trouble;
  for (const auto& row : found.rows)
    if (row.result.failed()) return row.run.id + ": " + row.result.status + ", " + row.result.cause;
  const bool any = std::any_of(found.rows.begin(), found.rows.end(), [](const auto& row) { return row.result.done(); });
  if (any && found.horizon.ends && found.horizon.until_s <= report.study.plan.start)
    return "the perturbed runs diverge before the first stored states";
  return report.ended_by.empty() ? "the budget ended before" : report.ended_by;
}

/// States the accuracy of the peaks, because ships are designed for the peaks of a load.
void say_peaks(const Merit& m, const Findings& found, std::vector<std::string>& lines) {
  if (!found.measure.is_load() || !(found.reference.std.mean > 0) || !(found.reference.p99.mean > 0)) return;
  const auto change = [](const Estimate& of, const Estimate& reference) {
    return fmt::format("{:+.2g} %", 100 * (of.mean / reference.mean - 1));
  };
  lines.push_back(
      fmt::format("Peaks are not part of the recommendation. With the recommended setting the standard "
                  "deviation of the load differs by {} from the reference's, the 99 % load by {}, and the "
                  "largest load by {}.",
                  change(m.load_std, found.reference.std), change(m.load_p99, found.reference.p99),
                  change(m.load_max, found.reference.max)));
}

std::string coverage_text(const Coverage& coverage) {
  return fmt::format("held in {} of {} run{}; in half of them it was more than {:.2g} times as large as the error.",
                     std::lround(coverage.share * coverage.runs), coverage.runs, coverage.runs == 1 ? "" : "s",
                     coverage.width);
}

void say_errors(const SceneReport& report, std::vector<std::string>& lines) {
  const Findings& found = report.found;
  const Merit* worst = nullptr;
  for (const auto& m : found.merits)
    if (m.significant && m.error >= found.check.moves.value_or(0) && (worst == nullptr || m.error > worst->error))
      worst = &m;
  if (worst != nullptr)
    lines.push_back(fmt::format("The largest significant error is that of \"{}\": {} ({}).",
                                report.label(worst->setting), quantity_text(worst->error, found.measure.unit),
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

std::vector<std::string> answer_lines(const SceneReport& report) {
  std::vector<std::string> lines;
  const Plan& plan = report.study.plan;
  if (plan.end < plan.scene_end)
    lines.push_back(fmt::format("Over {} only: the budget shortened the runs from {:.3g} s.", window_text(report),
                                plan.scene_end - plan.start));
  if (!report.compared())
    lines.push_back("Nothing can be compared: " + blocked(report) + ".");
  else if (report.study.ablation)
    say_ablation(report, lines);
  else
    say_price(report, lines);
  return lines;
}

std::vector<std::string> detail_lines(const SceneReport& report) {
  const Findings& found = report.found;
  std::vector<std::string> lines;
  if (!report.compared()) return lines;
  if (!report.study.ablation && found.merits.front().done > 0) {
    if (found.choice.chosen) say_peaks(found.merits[*found.choice.chosen], found, lines);
    say_errors(report, lines);
  }
  if (found.horizon.ends)
    lines.push_back(fmt::format(
        "The motions of single bodies can be predicted until {:.3g} s of {:g} s. From then on two runs that begin "
        "1e-12 m apart differ by more than {}.{}",
        found.horizon.until_s, report.study.plan.end, quantity_text(found.horizon.threshold_m, "m"),
        found.measure.is_load() && found.shared.size() > 1 ? " The effect of chance on mean loads is measured "
                                                             "separately, from realisations whose ice differs from "
                                                             "the start."
                                                           : ""));
  if (found.coverage) {
    lines.push_back("With all runs, the estimated error of the load " + coverage_text(*found.coverage));
    lines.push_back("The +- that each run prints by itself " + coverage_text(*found.coverage_alone));
  }
  for (const auto& order : found.orders)
    lines.push_back(fmt::format(
        "Over {} steps the error of \"{}\" {}.", order.steps, order.rest,
        order.order > 0 ? fmt::format("falls with order {:.2f}", order.order) : "does not fall with the step"));
  return lines;
}

std::string report_text(const SceneReport& report) {
  std::string text;
  for (const auto& lines : {answer_lines(report), detail_lines(report), caveat_lines(report),
                            outlook_lines(report.outlook, report.study, report.found)})
    for (const auto& line : lines) text += line + "\n";
  const StudyTiming& timing = report.timing;
  if (timing.jobs > 1 && timing.jobs <= timing.cores && std::isfinite(timing.busy))
    text += std::isfinite(timing.slowdown)
                ? fmt::format(
                      "The parallel efficiency was {:.2f}: of {} jobs {:.2f} were at work on average, each {:.2f} "
                      "times as slow as alone.\n",
                      timing.efficiency(), timing.jobs, timing.busy, timing.slowdown)
                : fmt::format(
                      "The parallel efficiency was at most {:.2f}: of {} jobs {:.2f} were at work on average. The "
                      "runs are too short to show how much they slow each other down.\n",
                      timing.busy / timing.jobs, timing.jobs, timing.busy);
  if (std::isfinite(report.found.time_spread))
    text += fmt::format("Computing times of runs of one setting scatter by {} (standard deviation).\n",
                        percent_text(report.found.time_spread));
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace nilas::compare
