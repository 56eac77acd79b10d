#include "apps/compare/problems/problem_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <tuple>

#include "apps/compare/problems/problem_report.h"
#include "apps/compare/problems/problem_study_plan.h"
#include "apps/compare/problems/problem_study_run.h"
#include "apps/compare/problems/problem_study_table.h"
#include "apps/compare/workshop/json_store.h"
#include "apps/compare/workshop/narrator.h"
#include "apps/compare/workshop/study_folder.h"
#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/base/machine.h"
#include "core/output/file/output_file.h"
#include "core/output/run/claim_folder.h"
#include "core/output/text/console.h"
#include "core/output/text/plot.h"

namespace nilas {

namespace {

namespace fs = std::filesystem;

constexpr double k_usual_budget = 1200;  // [s]
constexpr const char* k_json = "compare.json";
constexpr const char* k_table = "compare.csv";
constexpr const char* k_work = ".runs";  // what runs print, each until it is judged

StudyFiles own_files() {
  return {{k_json, k_table}, [](const std::string& name) {
            static const std::set<std::string> names{k_json, k_table, "compare.html", k_work};
            const std::string part = ".part";  // a file that was being replaced when the study was killed
            const std::string whole = name.ends_with(part) ? name.substr(0, name.size() - part.size()) : name;
            return names.count(whole) > 0 || is_problem_picture_file(name);
          }};
}

fs::path usual_folder(const fs::path& problems) {
  const fs::path plain = fs::absolute(problems).lexically_normal();
  const std::string name = (plain.has_filename() ? plain : plain.parent_path()).filename().string();
  return dated_folder(name);
}

std::string machine() {
  const std::string processor = processor_text();
  return fmt::format("{}{}{}, {} cores", system_text(), processor.empty() ? "" : ", ", processor, usable_cores());
}

/// Options of an earlier study, from its own file; `report` gets what it measured.
ProblemStudyOptions stored_options(const ProblemStudyOptions& asked, ProblemReport& report) {
  const fs::path file = asked.resume / k_json;
  const auto json = read_json(file);
  ProblemStudyOptions options = asked;
  try {
    const auto& stored = json.at("options");
    options.folder = stored.at("problems").get<std::string>();
    options.solvers = stored.at("solvers").get<std::vector<std::string>>();
    options.laws = stored.at("laws").get<std::vector<std::string>>();
    options.tolerances = stored.at("tolerances_m_s").get<std::vector<double>>();
    if (!(options.budget_s > 0)) options.budget_s = stored.at("budget_s").get<double>();
    if (options.jobs <= 0) options.jobs = stored.at("jobs").get<int>();
    report.limit_s = json.at("limit_s").get<double>();
    report.wall_s = json.at("wall_s").get<double>();
  } catch (const nlohmann::json::exception&) {
    throw InputError(file.string() + ": found no study of stored problems");
  }
  options.out = asked.resume;
  return options;
}

ProblemStudyOptions completed(ProblemStudyOptions options) {
  if (!(options.budget_s > 0)) options.budget_s = k_usual_budget;
  if (options.jobs <= 0) options.jobs = usable_cores();
  if (options.laws.empty()) options.laws = {"coulomb"};
  if (options.out.empty()) options.out = usual_folder(options.folder);
  options.folder = fs::absolute(options.folder).lexically_normal();
  return options;
}

using RunKey = std::tuple<std::string, std::string, std::string, double>;
RunKey key_of(const StudyRow& row) {
  return {row.problem.name, row.solver, row.law, std::isnan(row.tolerance) ? 0 : row.tolerance};
}

/// Of the first rows, those that were runs.
std::size_t runs_among(const std::vector<StudyRow>& rows) {
  return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [](const StudyRow& row) {
    return !row.solver.empty() && row.outcome != RunOutcome::not_applicable;
  }));
}

/// The table of a study on disk and in memory: a row per run as each ends.
class Table {
 public:
  /// Begins an empty one.
  explicit Table(const fs::path& file) : file_(file), rows_(), disk_(std::make_unique<OutputFile>(file)) {
    disk_->append(study_header());
  }
  /// Goes on after the rows of earlier sessions.
  Table(const fs::path& file, StoredRows stored)
      : file_(file), rows_(std::move(stored.rows)), disk_(std::make_unique<OutputFile>(file, "", stored.bytes)) {
    for (const auto& row : rows_) keys_.insert(key_of(row));
  }

  void add(const StudyRow& row) {
    disk_->append(study_line(row));
    keys_.insert(key_of(row));
    rows_.push_back(row);
  }
  bool holds(const StudyRow& row) const { return keys_.count(key_of(row)) > 0; }
  const std::vector<StudyRow>& rows() const { return rows_; }

  /// Writes it once more, sorted.
  void close() {
    disk_->close();
    sort_study(rows_);
    std::string text = study_header();
    for (const auto& row : rows_) text += study_line(row);
    write_whole(file_, text);
  }

 private:
  fs::path file_;
  std::vector<StudyRow> rows_;
  std::unique_ptr<OutputFile> disk_;
  std::set<RunKey> keys_;
};

/// A study with its folder, its problems and its plan.
struct Opened {
  ProblemStudyOptions options;
  StudyFolder folder;
  std::vector<StudyFile> files;
  Table table;
  StudyPlan plan;
  ProblemReport report;  ///< but for its rows
  double wall_before_s;  ///< of earlier sessions
  std::size_t stored;    ///< rows of earlier sessions
  double started_s;      ///< by steady_seconds()

  double elapsed_s() const { return steady_seconds() - started_s; }
};

/// What the plan and the options say of the study.
void describe(const ProblemStudyOptions& options, const StudyPlan& plan, std::size_t runs_before,
              ProblemReport& report) {
  report.problems = options.folder;
  report.status = "running";
  report.solvers = options.solvers;
  report.laws = options.laws;
  report.tolerances = options.tolerances;
  report.budget_s = options.budget_s;
  report.limit_s = plan.limit_s;
  report.jobs = options.jobs;
  report.planned = plan.runs.size() + plan.dropped.size() + runs_before;
  report.estimate_s = plan.estimate_s;
  report.at_most_s = plan.at_most_s;
  report.machine = machine();
}

Opened open_study(const ProblemStudyOptions& asked) {
  const double started_s = steady_seconds();
  const bool goes_on = !asked.resume.empty();
  ProblemReport report;
  const ProblemStudyOptions options = completed(goes_on ? stored_options(asked, report) : asked);
  const StudyChoice choice{options.solvers, options.laws, options.tolerances, report.limit_s};
  validate(choice);
  std::vector<StudyFile> files = survey(options.folder);
  StudyFolder folder = goes_on ? StudyFolder::open(options.out, own_files())
                               : StudyFolder::claim(options.out, own_files(), options.force);
  const fs::path csv = options.out / k_table;
  Table table = goes_on ? Table(csv, read_study(csv)) : Table(csv);
  fs::create_directories(options.out / k_work);
  const std::size_t stored = table.rows().size(), runs_before = runs_among(table.rows());
  const double start_s = run_child({{own_program().string(), "solvers"}, {}, {}, 0}).wall_s;
  StudyPlan plan = make_plan(files, choice, options.budget_s * std::min(options.jobs, usable_cores()), start_s,
                             [&](const StudyRow& row) { return table.holds(row); });
  for (const auto& row : plan.settled)
    if (!table.holds(row)) table.add(row);
  for (const auto& run : plan.dropped) report.dropped.push_back(row_of(files[run.file], run));
  describe(options, plan, runs_before, report);
  const double wall_before_s = report.wall_s;
  return {options,           std::move(folder), std::move(files), std::move(table), std::move(plan),
          std::move(report), wall_before_s,     stored,           started_s};
}

/// compare.json and page of what is done so far, with pictures at the end.
struct WrittenReport {
  ProblemReport report;  ///< with its rows, sorted
  std::vector<SolverComparison> comparisons;
  std::string no_pictures;  ///< why there are none; empty where there are
};

WrittenReport write_report(const Opened& study, bool with_pictures) {
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
  } catch (const PlotError& error) {
    written.no_pictures = error.what();
  }
  write_problem_page(study.options.out, report, written.comparisons, pictures, written.no_pictures);
  write_json(study.options.out / k_json, problem_report_json(report, written.comparisons));
  return written;
}

void tell_plan(const Opened& study, const Narrator& narrator) {
  const StudyPlan& plan = study.plan;
  narrator.line(fmt::format("{} problems in {}, {} runs, each up to {:g} s, {} at a time: about {}, at most {}",
                            study.files.size(), study.options.folder.string(), plan.runs.size(), plan.limit_s,
                            study.options.jobs, duration_text(plan.estimate_s / study.options.jobs),
                            duration_text(plan.at_most_s / study.options.jobs)));
  for (const auto& row : plan.settled)
    if (row.solver.empty()) narrator.line("unreadable: " + row.message);
  if (study.stored > 0) narrator.line(fmt::format("{} rows are done already", study.stored));
  if (!study.report.dropped.empty())
    narrator.line(fmt::format("no room within {:g} s for: {}", study.options.budget_s, dropped_text(study.report)));
}

/// Says every twentieth of the runs, and when the page is due: now and then only, since drawing would take the cores
/// from what is timed.
class Progress {
 public:
  Progress(std::size_t runs, const Narrator& narrator) : runs_(runs), narrator_(narrator) {}

  /// A run has ended. Returns whether the page is due.
  bool ended(double elapsed_s) {
    constexpr std::size_t k_marks = 20;
    constexpr double k_percent = 100, k_page_every_s = 20;
    ++ended_;
    const std::size_t mark = k_marks * ended_ / runs_;
    if (mark > last_mark_)
      narrator_.line(fmt::format("{:.0f} % of the runs, {}", k_percent * static_cast<double>(mark) / k_marks,
                                 duration_text(elapsed_s)));
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

/// A run that was ended early may have left no file.
std::string contents(const fs::path& file) { return fs::exists(file) ? file_bytes(file) : ""; }

void make_runs(Opened& study, const Narrator& narrator, const std::function<bool()>& stop) {
  const std::vector<StudyRun>& runs = study.plan.runs;
  const auto file_of = [&](std::size_t k, const char* kind) {
    return study.options.out / k_work / fmt::format("{}.{}", k, kind);
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
    if (progress.ended(study.elapsed_s())) write_report(study, false);
  };
  run_children(tasks, study.options.jobs, hooks);
}

/// The session with a page from its start on. Where the disk is full, what is done is shown as far as there is room.
void run_session(Opened& study, const Narrator& narrator, const std::function<bool()>& stop) {
  try {
    write_report(study, false);
    make_runs(study, narrator, stop);
  } catch (const FileError&) {
    try {
      study.report.status = "stopped by a file error";
      write_report(study, false);
    } catch (const FileError&) {
    }
    std::error_code ignored;
    fs::remove_all(study.options.out / k_work, ignored);
    throw;
  }
}

void tell_end(const WrittenReport& written, const Opened& study, const Narrator& narrator) {
  if (study.options.json)
    std::cout << json_text(problem_report_json(written.report, written.comparisons)) << std::flush;
  for (const auto& one : written.comparisons) narrator.sentences(headline(one));
  if (written.report.dropped.size() > study.plan.dropped.size())
    narrator.sentences("left out for lack of time: " + dropped_text(written.report));
  narrator.line(
      fmt::format("{}; the report is {}", written.report.status, (study.options.out / "compare.html").string()));
  if (!written.no_pictures.empty()) Narrator::warning(written.no_pictures);
}

}  // namespace

int run_problem_study(const ProblemStudyOptions& options, const std::function<bool()>& stop) {
  const Narrator narrator(options.json, options.quiet);
  Opened study = open_study(options);
  tell_plan(study, narrator);
  run_session(study, narrator, stop);
  const bool stopped = stop && stop();
  study.report.status = stopped ? "interrupted" : study.report.dropped.empty() ? "done" : "out of budget";
  study.table.close();
  const WrittenReport written = write_report(study, true);
  fs::remove_all(study.options.out / k_work);
  study.folder.release();
  tell_end(written, study, narrator);
  return stopped ? exit_interrupted : exit_done;
}

}  // namespace nilas
