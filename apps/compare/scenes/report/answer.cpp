#include "apps/compare/scenes/report/answer.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/compare/scenes/judge/ranking.h"
#include "apps/compare/scenes/report/run_command.h"

namespace nilas::compare {

namespace {

/// "6.1 times faster than", "1.3 times slower than", "about as fast as".
std::string speed_text(double ratio) {
  constexpr double k_alike = 1.05;
  if (ratio > k_alike) return fmt::format("{:.2g} times faster than", ratio);
  if (ratio < 1 / k_alike) return fmt::format("{:.2g} times slower than", 1 / ratio);
  return "about as fast as";
}

/// The quantity of which errors in percent are shares.
std::string scale_text(const SceneReport& report) {
  const Findings& found = report.found;
  if (found.measure.is_load())
    return fmt::format("the reference's mean ice load ({} along the course over {})",
                       quantity_text(found.reference.mean.mean, "N"), window_text(report));
  if (found.measure.name == "turn") return "1 rad";
  return fmt::format("the longest path of a body ({})", quantity_text(found.measure.scale, "m"));
}

/// Whether the error of a setting may be chance, and the limit of that is above the target.
bool hidden_by_chance(const Merit& m, const Findings& found) {
  return !m.significant && m.floor > k_target * found.measure.scale;
}

std::string accuracy_text(const Merit& m, const SceneReport& report) {
  const Findings& found = report.found;
  const Measure& measure = found.measure;
  const std::string floor = quantity_text(m.floor, measure.unit), share = percent_text(m.floor / measure.scale);
  if (measure.is_load()) {
    if (hidden_by_chance(m, found))
      return fmt::format("its mean ice load cannot be distinguished from {}; differences up to {} ({}) may be chance",
                         scale_text(report), floor, share);
    return fmt::format("its mean ice load is within {} of {}", percent_text(k_target), scale_text(report));
  }
  const std::string error = measure.name == "turn" ? "error in attitude" : "error in position";
  if (hidden_by_chance(m, found))
    return fmt::format("its {} is not significant; errors up to {} may be chance", error, floor);
  return fmt::format("its {} is below {} of {}", error, percent_text(k_target), scale_text(report));
}

/// Names the setting that was faster than the recommended one and as accurate, but not significantly faster.
void say_faster(const SceneReport& report, std::vector<std::string>& lines) {
  const Findings& found = report.found;
  if (!found.choice.faster) return;
  const Merit &best = found.merits[*found.choice.chosen], &other = found.merits[*found.choice.faster];
  const std::string took = three_digits(other.time) + " s", instead = three_digits(best.time) + " s";
  if (took == instead) return;
  const std::string scatter = std::isnan(found.time_spread)
                                  ? "the scatter of times was not measured"
                                  : "times of one setting scatter by " + percent_text(found.time_spread);
  lines.push_back(fmt::format(
      "{} was as accurate and took {} instead of {}, but only a factor above {:.3g} is significant, since {}.",
      report.quoted_label(other.setting), took, instead, significant_speed_ratio(found.time_spread), scatter));
}

/// The recommended setting, its accuracy and its computing time.
std::string recommendation(const SceneReport& report) {
  const Findings& found = report.found;
  const Merit &own = found.merits.front(), &best = found.merits[*found.choice.chosen];
  const std::string own_name = full_label(report.study.plan.settings.front());
  const std::string accuracy = accuracy_text(best, report);
  if (best.setting == own.setting)
    return fmt::format(
        "Keep the scene's own setting ({}): {}, and no other setting that is as accurate{} is "
        "significantly faster. It takes {} s of computing per simulated second.",
        own_name, accuracy,
        found.choice.by_luck  ? ", as a whole and in its parts,"
        : found.choice.deeper ? " and lets bodies penetrate no deeper"
                              : "",
        three_digits(own.time));
  const std::string name = report.quoted_label(best.setting);
  return fmt::format(
      "Use {0}: {1}. {0} takes {2} s of computing per simulated second, and the scene's own setting ({3}) "
      "takes {4} s. So {0} is {5} the scene's own setting.",
      name, accuracy, three_digits(best.time), own_name, three_digits(own.time), speed_text(own.time / best.time));
}

void say_recommendation(const SceneReport& report, std::vector<std::string>& lines) {
  const Findings& found = report.found;
  const Merit& best = found.merits[*found.choice.chosen];
  lines.push_back(recommendation(report));
  say_faster(report, lines);
  if (!hidden_by_chance(best, found)) return;
  const std::size_t count = best.realisations.size();
  lines.push_back(
      fmt::format("By chance alone, the means over {} of {} realisation{} differ by so much (95 %). Smaller errors "
                  "cannot be shown.",
                  window_text(report), count, count == 1 ? "" : "s"));
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
  if (found.choice.by_luck)
    return fmt::format(
        "No setting is recommended: within {} of {} are only combinations of which a part alone is far off.",
        percent_text(k_target), scale_text(report));
  return fmt::format("No setting is recommended: none is within {} of {}.", percent_text(k_target), scale_text(report));
}

/// Names settings that are faster and seem as accurate, with the reason why they are not recommended.
void say_why_not_faster(const SceneReport& report, std::vector<std::string>& lines) {
  const Findings& found = report.found;
  const Merit& own = found.merits.front();
  if (found.choice.by_luck) {
    const Merit& lucky = found.merits[*found.choice.by_luck];
    const Merit& part = found.merits[*lucky.faulty_part];
    lines.push_back(fmt::format(
        "\"{}\" seems as accurate and is {} the scene's own setting, but it is not recommended: \"{}\" alone has a "
        "significant error of {} ({}), so that two errors may cancel by chance.",
        report.label(lucky.setting), speed_text(own.time / lucky.time), report.label(part.setting),
        quantity_text(part.error, found.measure.unit), percent_text(part.error / found.measure.scale)));
  }
  if (!found.choice.deeper) return;
  const Merit& deep = found.merits[*found.choice.deeper];
  lines.push_back(
      fmt::format("\"{}\" is as accurate and {} the scene's own setting, but lets bodies penetrate each other "
                  "by up to {} (the scene's own setting: {}).",
                  report.label(deep.setting), speed_text(own.time / deep.time),
                  quantity_text(deep.penetration_max_m, "m"), quantity_text(own.penetration_max_m, "m")));
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
  say_why_not_faster(report, lines);
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
  else if (found.measure.is_load())
    lines.push_back(fmt::format("Without any simplification the mean ice load is {} along the course, over {}.",
                                quantity_text(found.merits.front().load.mean, "N"), window_text(report)));
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
  if (!report.ended_by.empty()) return report.ended_by;
  return report.too_long.empty() ? "the budget ended before"
                                 : "the missing runs were expected to take more than was left of the budget";
}

}  // namespace

std::vector<std::string> answer_lines(const SceneReport& report) {
  std::vector<std::string> lines;
  const Plan& plan = report.study.plan;
  if (plan.end < plan.scene_end)
    lines.push_back(fmt::format("Only {} was compared: the budget shortened the runs from {} s.", window_text(report),
                                moment_text(plan.scene_end - plan.start)));
  if (!report.compared())
    lines.push_back("Nothing can be compared: " + blocked(report) + ".");
  else if (report.study.ablation)
    say_ablation(report, lines);
  else
    say_price(report, lines);
  return lines;
}

std::string report_text(const SceneReport& report) {
  std::string text;
  for (const auto& line : answer_lines(report)) text += line + "\n";
  if (const std::string command = run_command(report); !command.empty())
    text += "To run the recommended setting:\n  " + command + "\n";
  for (const auto& lines :
       {detail_lines(report), caveat_lines(report), outlook_lines(report.outlook, report.study, report.found)})
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
