/// The limits of the result of a comparison.
#include <fmt/format.h>

#include <algorithm>

#include "apps/compare/scenes/report/answer.h"
#include "apps/compare/scenes/report/paired_text.h"

namespace nilas::compare {

namespace {

std::string plural(std::size_t count) { return count == 1 ? "" : "s"; }

void say_coverage_limits(const SceneReport& report, std::vector<std::string>& lines) {
  const Findings& found = report.found;
  const Plan& plan = report.study.plan;
  if (found.shared.size() < static_cast<std::size_t>(plan.realisations) && !found.shared.empty())
    lines.push_back(
        fmt::format("Means are over {} only, which the settings have in common; compare.csv holds the runs of "
                    "the others.",
                    realisations_text(found.shared)));
  const auto partial = static_cast<std::size_t>(
      std::count_if(found.merits.begin(), found.merits.end(), [](const Merit& m) { return m.partial; }));
  if (partial > 0)
    lines.push_back(fmt::format("{} setting{} (marked *) lack{} a run in {} {}, and {} not ranked.", partial,
                                plural(partial), partial == 1 ? "s" : "",
                                found.shared.size() == 1 ? "the shared" : "one of the shared",
                                realisations_text(found.shared), partial == 1 ? "is" : "are"));
}

/// The runs that the budget did not allow. Time may be left where a run was expected to take more than that.
void say_late_runs(const SceneReport& report, std::vector<std::string>& lines) {
  const std::size_t planned = report.study.plan.runs.size(), refused = report.too_long.size(),
                    ended = report.late.size() - refused;
  if (ended > 0)
    lines.push_back(fmt::format("The budget of {:g} s was used up before {} of {} runs were done.",
                                report.study.budget_s, ended, planned));
  if (refused > 0)
    lines.push_back(fmt::format("{} of {} runs did not begin: {} expected to take more than was left of the budget.",
                                refused, planned, refused == 1 ? "it was" : "they were"));
}

/// The share of its steps in which the reference missed its tolerance, in the worst of its runs.
double unconverged_reference(const Findings& found) {
  double share = 0;
  for (const auto& row : found.rows)
    if (row.run.kind == RunKind::reference && row.result.done())
      share = std::max(share, row.result.summary.unconverged_steps / row.result.summary.steps);
  return share;
}

void say_reference_limits(const SceneReport& report, std::vector<std::string>& lines) {
  const Findings& found = report.found;
  const SceneStudy& study = report.study;
  if (!found.judges.stand_in.empty())
    lines.push_back(
        fmt::format("No run of the reference is done ({}). Settings are judged by {} in its place, whose own "
                    "error is not known.",
                    found.judges.trouble.empty() ? "not run" : found.judges.trouble, found.judges.stand_in));
  else if (!found.judges.trouble.empty())
    lines.push_back(
        fmt::format("Only {} of {} realisations can be judged, because the others lack a run of the reference ({}).",
                    found.judges.realisations, study.plan.realisations, found.judges.trouble));
  if (found.judges.stand_in.empty() && !found.check.moves && !study.ablation && study.reference == "auto" &&
      !study.event_driven)
    lines.emplace_back(
        "How much the reference changes with its step is not known, because the run that shows it is not done.");
  if (found.check.coarse)
    lines.push_back(
        fmt::format("The reference itself changes by {} when its step is doubled, which is more than the "
                    "smallest significant error. Do not rely on errors of that size.",
                    quantity_text(*found.check.moves, found.measure.unit)));
  if (const double share = unconverged_reference(found); share > 0 && study.reference == "auto")
    lines.push_back(fmt::format("The reference missed its tolerance of {:.0e} m/s in {} of its steps.",
                                study.plan.reference.tolerance, percent_text(share)));
}

void say_time_limits(const StudyTiming& timing, double time_spread, std::vector<std::string>& lines) {
  if (timing.jobs > timing.cores)
    lines.push_back(fmt::format("{} jobs share {} core{}. They slow each other down, and by how much is not measured.",
                                timing.jobs, timing.cores, plural(static_cast<std::size_t>(timing.cores))));
  if (timing.slowdown > 1 + std::max(0.1, 2 * time_spread))
    lines.push_back(
        fmt::format("Runs next to each other took {:.2f} times as long as alone. All times here are longer by "
                    "about this factor, which is similar for all settings.",
                    timing.slowdown));
}

}  // namespace

std::vector<std::string> caveat_lines(const SceneReport& report) {
  std::vector<std::string> lines;
  const Findings& found = report.found;
  if (!report.ended_by.empty())
    lines.push_back("This comparison is not complete (" + report.ended_by +
                    "). It shows what was done until then, and --resume continues it.");
  say_coverage_limits(report, lines);
  say_late_runs(report, lines);
  say_reference_limits(report, lines);
  if (!found.horizon.known)
    lines.emplace_back("How long motions can be predicted is not known, because no perturbed run is done.");
  for (const auto& m : found.merits)
    if (m.failed > 0)
      lines.push_back(
          fmt::format("\"{}\": {} of {} runs failed ({}).", report.label(m.setting), m.failed, m.planned, m.trouble));
  say_time_limits(report.timing, found.time_spread, lines);
  return lines;
}

}  // namespace nilas::compare
