#include "apps/compare/scenes/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "apps/compare/scenes/judge/judge.h"
#include "apps/compare/scenes/report/answer.h"
#include "apps/compare/scenes/report/page.h"
#include "apps/compare/scenes/report/plan_text.h"
#include "apps/compare/scenes/report/tables.h"
#include "apps/compare/scenes/run/given_reference.h"
#include "apps/compare/scenes/run/prepare.h"
#include "apps/compare/scenes/run/scheduler.h"
#include "apps/compare/workshop/json_store.h"
#include "apps/compare/workshop/special_numbers.h"
#include "core/base/error.h"
#include "core/output/run/claim_folder.h"
#include "core/output/text/console.h"

namespace nilas::compare {

namespace {

using Stop = std::function<bool()>;

/// A study with its folder and the time at which its budget began.
struct Opened {
  SceneStore store;
  SceneStudy study;
  double started_s;     ///< start of the budget, on the clock of steady_seconds() [s]
  std::string trouble;  ///< why the first setting made no step while its cost was measured
};

SceneStudy described(const StudyOptions& options, const scene::Scene& scene, const Grid& grid) {
  constexpr double k_budget_s = 1200;
  SceneStudy study;
  study.scene = std::filesystem::absolute(scene.file);
  study.fingerprint = scene.fingerprint;
  study.overrides = options.overrides;
  study.seed = scene.seed;
  study.ablation = options.grid.ablate;
  study.reference = options.reference == "auto" ? "auto" : std::filesystem::absolute(options.reference).string();
  study.jobs = options.jobs > 0 ? options.jobs : usable_cores();
  study.budget_s = options.budget_s.value_or(k_budget_s);
  study.keep_runs = options.keep_runs;
  if (study.ablation) study.absent = absent_simplifications(scene);
  for (const auto& refused : grid.refused)
    study.refused.push_back({label_of(refused.setting, grid.settings.front()), refused.reason});
  return study;
}

/// Takes a folder and makes the plan. Returns nothing if the user stopped it before there was a plan.
std::optional<Opened> begin_study(const StudyOptions& options, const Narrator& narrator, const Stop& stop) {
  const double started_s = output::steady_seconds();
  const scene::Scene scene = scene::read_scene(options.scene, options.overrides);
  const Grid grid = make_grid(scene, options.overrides, options.grid);
  if (options.reference != "auto") demand_reference_run(options.reference, scene);
  const std::filesystem::path out =
      options.out.empty() ? output::dated_folder(scene.name + "-compare") : std::filesystem::path(options.out);
  Opened opened{SceneStore(out, options.force), described(options, scene, grid), started_s, ""};
  try {
    const PlanWishes wishes{options.realisations,      options.reference_tolerance, options.fixed_reference_tolerance,
                            options.grid.names_axes(), core_of(grid, options.grid), started_s};
    opened.trouble = prepare(scene, grid, wishes, opened.store, narrator, stop, opened.study);
    if (!stop()) opened.store.write(opened.study);
  } catch (...) {
    opened.store.abandon();
    throw;
  }
  if (stop()) {  // there is no plan that a resumed comparison could continue
    opened.store.abandon();
    narrator.line("The comparison was interrupted before it began.");
    return std::nullopt;
  }
  const double used_s = output::steady_seconds() - started_s, budget_s = opened.study.budget_s;
  for (const auto& line : plan_lines(opened.study, budget_s > 0 ? std::max(0.0, budget_s - used_s) : k_infinity))
    narrator.sentences(line);
  return opened;
}

/// Opens an earlier study, with the realisations, budget and jobs that are asked for. Throws InputError, FileError.
Opened resume_study(const StudyOptions& options) {
  const double started_s = output::steady_seconds();
  SceneStore store(options.resume);
  SceneStudy study = store.read();
  if (scene::read_scene(study.scene, study.overrides).fingerprint != study.fingerprint)
    throw InputError("--resume: " + study.scene.string() + " has changed since the comparison began");
  if (options.jobs > 0) study.jobs = options.jobs;
  if (options.realisations) {
    if (*options.realisations < study.plan.realisations)
      throw InputError(fmt::format("--seeds: found {}; the comparison has {} realisations, and only more are allowed",
                                   *options.realisations, study.plan.realisations));
    extend_realisations(study.plan, *options.realisations);
    store.write(study);
  }
  if (options.budget_s) {
    const bool more = *options.budget_s == 0 || *options.budget_s > study.budget_s;
    study.budget_s = *options.budget_s;
    if (more) forget_slow_runs(study, store);
    store.write(study);
  }
  return {std::move(store), std::move(study), started_s, ""};
}

Judged judged_by(const SceneStudy& study) {
  if (study.ablation) return Judged::by_first_setting;
  return study.reference != "auto" ? Judged::by_one_run : Judged::by_reference;
}

StudyTiming timing_of(const SceneStudy& study, const SessionEnd& session, double elapsed_s) {
  StudyTiming timing{study.jobs, usable_cores(), elapsed_s};
  const auto own = session.results.find("s00-r0");
  constexpr double k_least_ms = 500;  // shorter times scatter too much
  if (study.probe_ms > k_least_ms && own != session.results.end() && own->second.first_steps_ms > 0 && study.jobs > 1 &&
      study.jobs <= timing.cores)
    timing.slowdown = own->second.first_steps_ms / study.probe_ms;
  if (session.pool_s > 0 && session.busy_s > 0) timing.busy = session.busy_s / session.pool_s;
  return timing;
}

SceneReport report_of(const Opened& opened, const SessionEnd& session, const std::string& ended_by) {
  const SceneStudy& study = opened.study;
  const std::filesystem::path& folder = opened.store.path();
  SceneReport report{study,
                     judge_runs(study.plan, session.results, folder, judged_by(study)),
                     timing_of(study, session, output::steady_seconds() - opened.started_s),
                     session.late,
                     session.too_long,
                     opened.trouble,
                     ended_by,
                     {}};
  report.outlook = outlook(study, report.found, folder, session.left_s, session.realisation_s);
  if (const auto own = session.results.find("s00-r0");
      study.budget_s > 0 && own != session.results.end() && !report.compared())
    report.outlook.least_s =
        needed_budget(study.plan, run_end(own->second, study.plan.start), session.runs_begun_s, study.jobs).value_or(0);
  return report;
}

/// Writes a page at the start, so that there is one whatever ends the program.
void leave_first_page(const Opened& opened, const std::map<std::string, RunResult>& results) {
  SceneReport report{opened.study,
                     judge_runs(opened.study.plan, results, opened.store.path(), judged_by(opened.study)),
                     {opened.study.jobs, usable_cores()},
                     {},
                     {},
                     opened.trouble,
                     "it is still running, or was killed",
                     {}};
  write_first_page(opened.store.path(), report);
}

/// Writes and prints the report. Returns why a file could not be written, or an empty text.
std::string tell(const SceneReport& report, const Opened& opened, bool json, const Narrator& narrator) {
  std::string file_error;
  try {
    const std::string no_pictures = write_report(opened.store.path(), report);
    if (!no_pictures.empty()) Narrator::warning(no_pictures);
  } catch (const FileError& e) {
    file_error = e.what();
  }
  narrator.sentences(report_text(report));
  if (narrator.quiet())
    for (const auto& line : caveat_lines(report)) Narrator::warning(line);
  narrator.line(fmt::format("The comparison took {}. The report is {}",
                            output::duration_text(output::steady_seconds() - opened.started_s),
                            (opened.store.path() / "compare.html").string()));
  if (json) std::cout << json_text(report_json(report));
  return file_error;
}

int execute(Opened& opened, const StudyOptions& options, const Narrator& narrator, const Stop& stop) {
  SceneStudy& study = opened.study;
  std::map<std::string, RunResult> done = opened.store.results(study.plan);
  if (study.reference != "auto") take_reference(study, opened.store, done);
  leave_first_page(opened, done);
  const RunWords words{[&](const PlannedRun& run) {
                         const bool judges = run.kind == RunKind::reference || run.kind == RunKind::check;
                         return judges ? full_label(study.plan.setting_of(run))
                                       : label_of(study.plan.setting_of(run), study.plan.settings.front());
                       },
                       shorter_line};
  const SessionEnd session = make_runs(study, opened.store, done, opened.started_s, narrator, words, stop);
  const std::string ended_by = !session.file_error.empty() ? session.file_error : stop() ? "it was interrupted" : "";
  const SceneReport report = report_of(opened, session, ended_by);
  const std::string unwritten = tell(report, opened, options.json, narrator);
  if (!session.file_error.empty()) throw FileError(session.file_error);
  if (!unwritten.empty()) throw FileError(unwritten);
  if (stop()) return exit_interrupted;
  return report.compared() ? exit_done : exit_numerics;
}

}  // namespace

int run_study(const StudyOptions& options, const Stop& stop) {
  const Narrator narrator(options.json, options.quiet);
  if (!options.resume.empty()) {
    Opened opened = resume_study(options);
    return execute(opened, options, narrator, stop);
  }
  std::optional<Opened> opened = begin_study(options, narrator, stop);
  return opened ? execute(*opened, options, narrator, stop) : exit_interrupted;
}

}  // namespace nilas::compare
