#include "apps/compare/problems/problem_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "apps/compare/problems/problem_session.h"
#include "apps/compare/problems/problem_study_run.h"
#include "apps/compare/workshop/json_store.h"
#include "apps/compare/workshop/narrator.h"
#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/output/file/output_file.h"
#include "core/output/text/console.h"
#include "core/output/text/plot.h"

namespace nilas::compare {

namespace {

namespace fs = std::filesystem;

/// The report on what is done so far, as it was written.
struct WrittenReport {
  ProblemReport report;  ///< the report with its sorted rows
  std::vector<SolverComparison> comparisons;
  std::string no_pictures;  ///< why there are none; empty: there are
};

WrittenReport write_problem_report(const OpenedProblems& study, bool with_pictures) {
  WrittenReport written;
  ProblemReport& report = written.report = study.report;
  report.rows = study.table.rows();
  report.wall_s = study.wall_before_s + study.elapsed_s();
  sort_study(report.rows);
  written.comparisons = compare_solvers(report.rows);
  const bool any = !written.comparisons.empty();
  std::vector<ProblemPicture> pictures;
  if (!with_pictures && any) written.no_pictures = "they are drawn when the study ends.";
  try {
    if (with_pictures && any) pictures = draw_problem_study(study.options.out, report.rows, written.comparisons);
  } catch (const output::PlotError& error) {
    written.no_pictures = error.what();
  }
  write_problem_page(study.options.out, report, written.comparisons, pictures, written.no_pictures);
  write_json(study.options.out / k_problem_json, problem_report_json(report, written.comparisons));
  return written;
}

void tell_plan(const OpenedProblems& study, const Narrator& narrator) {
  const StudyPlan& plan = study.plan;
  narrator.line(fmt::format("{} problems in {}, {} runs, each up to {:g} s, {} at a time: about {}, at most {}",
                            study.files.size(), study.options.folder.string(), plan.runs.size(), plan.limit_s,
                            study.options.jobs, output::duration_text(plan.estimate_s / study.options.jobs),
                            output::duration_text(plan.at_most_s / study.options.jobs)));
  for (const auto& row : plan.settled)
    if (row.solver.empty()) narrator.line("unreadable file: " + row.message);
  if (study.stored > 0) narrator.line(fmt::format("{} rows of earlier sessions are there already", study.stored));
  if (!study.report.dropped.empty())
    narrator.line(
        fmt::format("the budget of {:g} s has no time for {}", study.options.budget_s, dropped_text(study.report)));
}

/// Prints the progress at every twentieth of the runs and decides when the page is written. That is not often, because
/// it takes a core from the runs that are timed.
class Progress {
 public:
  Progress(std::size_t runs, const Narrator& narrator) : runs_(runs), narrator_(narrator) {}

  /// Takes notice of a run that ended. Returns whether the page is to be written.
  bool ended(double elapsed_s) {
    constexpr std::size_t k_marks = 20;
    constexpr double k_page_every_s = 20;
    ++ended_;
    const std::size_t mark = k_marks * ended_ / runs_;
    if (mark > last_mark_)
      narrator_.line(fmt::format("{:.0f} % of the runs, {}", 100 * static_cast<double>(mark) / k_marks,
                                 output::duration_text(elapsed_s)));
    last_mark_ = mark;
    if (elapsed_s - page_at_s_ <= k_page_every_s) return false;
    page_at_s_ = elapsed_s;
    return true;
  }

 private:
  std::size_t runs_, ended_ = 0, last_mark_ = 0;
  double page_at_s_ = 0;
  const Narrator& narrator_;
};

/// The contents of a file; empty without one, because a run that was ended early may have left none.
std::string contents(const fs::path& file) { return fs::exists(file) ? file_bytes(file) : ""; }

void make_problem_runs(OpenedProblems& study, const Narrator& narrator, const std::function<bool()>& stop) {
  const std::vector<StudyRun>& runs = study.plan.runs;
  const auto file_of = [&](std::size_t k, const char* kind) {
    return study.options.out / k_problem_work / fmt::format("{}.{}", k, kind);
  };
  std::vector<ChildTask> tasks;
  for (std::size_t k = 0; k < runs.size(); ++k)
    tasks.push_back(
        task_of(study.files[runs[k].file], runs[k], study.plan.limit_s, file_of(k, "json"), file_of(k, "log")));
  Progress progress(runs.size(), narrator);
  ChildHooks hooks;
  hooks.stop = stop;
  hooks.begin = [&](std::size_t k, ChildTask&) {
    if (study.elapsed_s() <= study.options.budget_s) return true;
    study.report.dropped.push_back(row_of(study.files[runs[k].file], runs[k]));
    return false;
  };
  hooks.ended = [&](std::size_t k, const ChildResult& ended) {
    if (!ended.stopped)
      study.table.add(judge(study.files[runs[k].file], runs[k], study.plan.limit_s, ended, contents(file_of(k, "json")),
                            contents(file_of(k, "log"))));
    fs::remove(file_of(k, "json"));
    fs::remove(file_of(k, "log"));
    if (progress.ended(study.elapsed_s())) write_problem_report(study, false);
  };
  run_children(tasks, study.options.jobs, hooks);
}

/// Runs the session, with a page from its start on. After a file error it tries to write the report on what is done,
/// then throws the error again.
void run_session(OpenedProblems& study, const Narrator& narrator, const std::function<bool()>& stop) {
  try {
    write_problem_report(study, false);
    make_problem_runs(study, narrator, stop);
  } catch (const FileError&) {
    try {
      study.report.status = "stopped by a file error";
      write_problem_report(study, false);
    } catch (const FileError&) {
    }
    std::error_code ignored;
    fs::remove_all(study.options.out / k_problem_work, ignored);
    throw;
  }
}

void tell_end(const WrittenReport& written, const OpenedProblems& study, const Narrator& narrator) {
  if (study.options.json)
    std::cout << json_text(problem_report_json(written.report, written.comparisons)) << std::flush;
  for (const auto& one : written.comparisons) narrator.sentences(headline(one));
  if (written.report.dropped.size() > study.plan.dropped.size())
    narrator.sentences("The budget had no time for " + dropped_text(written.report));
  narrator.line(
      fmt::format("{}; the report is {}", written.report.status, (study.options.out / "compare.html").string()));
  if (!written.no_pictures.empty()) Narrator::warning(written.no_pictures);
}

}  // namespace

int run_problem_study(const ProblemStudyOptions& options, const std::function<bool()>& stop) {
  const Narrator narrator(options.json, options.quiet);
  OpenedProblems study = open_problems(options);
  tell_plan(study, narrator);
  run_session(study, narrator, stop);
  const bool stopped = stop && stop();
  study.report.status = stopped ? "interrupted" : study.report.dropped.empty() ? "done" : "out of budget";
  study.table.close();
  const WrittenReport written = write_problem_report(study, true);
  fs::remove_all(study.options.out / k_problem_work);
  study.folder.release();
  tell_end(written, study, narrator);
  return stopped ? exit_interrupted : exit_done;
}

}  // namespace nilas::compare
