#include "apps/compare/problems/problem_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <regex>
#include <set>
#include <tuple>

#include "apps/compare/problems/problem_study_page.h"
#include "apps/compare/problems/problem_study_plan.h"
#include "apps/compare/problems/problem_study_run.h"
#include "apps/compare/problems/problem_study_table.h"
#include "apps/compare/workshop/child.h"
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
constexpr const char* k_work = ".runs";  // what runs print, each until it is judged

/// A run that was ended early may have left no file.
std::string contents(const fs::path& file) { return fs::exists(file) ? file_bytes(file) : ""; }

fs::path usual_folder(const fs::path& problems) {
  const fs::path plain = fs::absolute(problems).lexically_normal();
  const std::string name = (plain.has_filename() ? plain : plain.parent_path()).filename().string();
  return dated_folder(name);
}

std::string machine() {
  const std::string processor = processor_text();
  return fmt::format("{}{}{}, {} cores", system_text(), processor.empty() ? "" : ", ", processor, usable_cores());
}

/// What an earlier study left, from its own files.
ProblemStudyOptions stored_options(const ProblemStudyOptions& asked, StudyReport& report) {
  const fs::path file = asked.resume / "compare.json";
  if (!fs::exists(file))
    throw FileError(file.string() + ": there is none, so there is no study in that folder to go on with");
  const auto json = nlohmann::json::parse(contents(file), nullptr, false);
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

/// Removes what an earlier study left, and nothing else.
void remove_outputs(const fs::path& folder) {
  const std::regex own(std::string(R"(compare\.(csv|json|html)(\.part)?|)") + k_study_figure_files);
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (std::regex_match(entry.path().filename().string(), own)) files.push_back(entry.path());
  for (const auto& file : files) fs::remove(file);
}

class Study {
 public:
  Study(const ProblemStudyOptions& asked, const std::function<bool()>& stop) : stop_(stop) {
    const bool goes_on = !asked.resume.empty();
    options_ = completed(goes_on ? stored_options(asked, report_) : asked);
    const StudyChoice choice{options_.solvers, options_.laws, options_.tolerances, report_.limit_s};
    validate(choice);
    files_ = survey(options_.folder);
    if (goes_on)
      lock_.emplace(options_.out);
    else
      lock_.emplace(claim_run_folder(options_.out, options_.force));
    if (goes_on)
      go_on();
    else
      begin();
    report_.wall_s = wall_before_;
    plan(choice);
  }

  int execute() {
    tell_plan();
    try {
      write_reports(false);
      run();
    } catch (const FileError&) {
      // what is done is still told, where there is room
      try {
        report_.status = "stopped by a file error";
        write_reports(false);
      } catch (const FileError&) {
      }
      std::error_code ignored;
      fs::remove_all(options_.out / k_work, ignored);
      throw;
    }
    return finish();
  }

 private:
  void begin() {
    remove_outputs(options_.out);
    table_.emplace(options_.out / "compare.csv");
    table_->append(study_header());
  }

  void go_on() {
    StoredRows stored = read_study(options_.out / "compare.csv");
    report_.rows = std::move(stored.rows);
    for (const auto& row : report_.rows) done_.insert(key_of(row));
    table_.emplace(options_.out / "compare.csv", "", stored.bytes);
    wall_before_ = report_.wall_s;
    stored_ = report_.rows.size();
  }

  void plan(const StudyChoice& choice) {
    fs::create_directories(options_.out / k_work);
    const double start_s = run_child({{own_program().string(), "solvers"}, {}, {}, 0}).wall_s;
    plan_ = make_plan(files_, choice, options_.budget_s * std::min(options_.jobs, usable_cores()), start_s,
                      [this](const StudyRow& row) { return done_.count(key_of(row)) > 0; });
    const std::size_t before = report_.rows.size();
    for (const auto& row : plan_.settled)
      if (done_.count(key_of(row)) == 0) add(row);
    for (const auto& run : plan_.dropped) report_.dropped.push_back(row_of(files_[run.file], run));
    report_.problems = options_.folder;
    report_.status = "running";
    report_.solvers = options_.solvers;
    report_.laws = options_.laws;
    report_.tolerances = options_.tolerances;
    report_.budget_s = options_.budget_s;
    report_.limit_s = plan_.limit_s;
    report_.jobs = options_.jobs;
    report_.planned = plan_.runs.size() + plan_.dropped.size() + runs_among(before);
    report_.estimate_s = plan_.estimate_s;
    report_.at_most_s = plan_.at_most_s;
    report_.machine = machine();
  }

  /// Of the first rows, those that were runs.
  std::size_t runs_among(std::size_t rows) const {
    const auto end = report_.rows.begin() + static_cast<std::ptrdiff_t>(rows);
    return static_cast<std::size_t>(std::count_if(report_.rows.begin(), end, [](const StudyRow& row) {
      return !row.solver.empty() && row.outcome != RunOutcome::not_applicable;
    }));
  }

  void tell(const std::string& text) const {
    if (!options_.quiet) (options_.json ? std::cerr : std::cout) << text << std::flush;
  }

  void tell_plan() const {
    tell(fmt::format("{} problems in {}, {} runs, each up to {:g} s, {} at a time: about {}, at most {}\n",
                     files_.size(), options_.folder.string(), plan_.runs.size(), plan_.limit_s, options_.jobs,
                     duration_text(plan_.estimate_s / options_.jobs), duration_text(plan_.at_most_s / options_.jobs)));
    for (const auto& row : plan_.settled)
      if (row.solver.empty()) tell(fmt::format("unreadable: {}\n", row.message));
    if (stored_ > 0) tell(fmt::format("goes on after {} rows that are done\n", stored_));
    if (!report_.dropped.empty())
      tell(fmt::format("no room within {:g} s for: {}\n", options_.budget_s, dropped_text(report_)));
  }

  void add(const StudyRow& row) {
    table_->append(study_line(row));
    done_.insert(key_of(row));
    report_.rows.push_back(row);
  }

  double elapsed() const { return steady_seconds() - started_; }

  void run() {
    const fs::path work = options_.out / k_work;
    const auto file_of = [&](std::size_t k, const char* kind) { return work / fmt::format("{}.{}", k, kind); };
    std::vector<ChildTask> tasks;
    for (std::size_t k = 0; k < plan_.runs.size(); ++k)
      tasks.push_back(
          task_of(files_[plan_.runs[k].file], plan_.runs[k], plan_.limit_s, file_of(k, "json"), file_of(k, "log")));
    ChildHooks hooks;
    hooks.stop = stop_;
    hooks.begin = [&](std::size_t k, ChildTask&) {
      if (elapsed() <= options_.budget_s) return true;
      report_.dropped.push_back(row_of(files_[plan_.runs[k].file], plan_.runs[k]));
      return false;
    };
    hooks.ended = [&](std::size_t k, const ChildResult& ended) {
      const StudyRun& one = plan_.runs[k];
      if (!ended.stopped)
        add(judge(files_[one.file], one, plan_.limit_s, ended, contents(file_of(k, "json")),
                  contents(file_of(k, "log"))));
      fs::remove(file_of(k, "json"));
      fs::remove(file_of(k, "log"));
      tell_progress();
    };
    run_children(tasks, options_.jobs, hooks);
  }

  /// Every twentieth of the runs, and the page now and then; drawing would take the cores from what is timed.
  void tell_progress() {
    constexpr std::size_t k_marks = 20;
    constexpr double k_percent = 100, k_page_every = 20;
    ++ended_;
    const std::size_t mark = k_marks * ended_ / plan_.runs.size();
    if (mark > last_mark_) {
      tell(fmt::format("{:.0f} % of the runs, {}\n", k_percent * static_cast<double>(mark) / k_marks,
                       duration_text(elapsed())));
      last_mark_ = mark;
    }
    if (elapsed() - page_written_ > k_page_every) write_reports(false);
  }

  /// compare.json, pictures and page of what is done so far.
  void write_reports(bool pictures) {
    StudyReport sorted = report_;
    sorted.wall_s = wall_before_ + elapsed();
    sort_study(sorted.rows);
    const std::vector<Comparison> comparisons = compare_solvers(sorted.rows);
    json_ = study_report_json(sorted, comparisons);
    std::vector<StudyFigure> figures;
    no_pictures_ = pictures || comparisons.empty() ? "" : "they are drawn when the study ends.";
    try {
      if (pictures && !comparisons.empty()) figures = draw_study(options_.out, sorted.rows, comparisons);
    } catch (const PlotError& error) {
      no_pictures_ = error.what();
    }
    write_study_page(options_.out, sorted, comparisons, figures, no_pictures_);
    write_whole(options_.out / "compare.json", json_.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
    page_written_ = elapsed();
  }

  int finish() {
    const bool stopped = stop_ && stop_();
    report_.status = stopped ? "interrupted" : report_.dropped.empty() ? "done" : "out of budget";
    table_->close();
    sort_study(report_.rows);
    std::string text = study_header();
    for (const auto& row : report_.rows) text += study_line(row);
    write_whole(options_.out / "compare.csv", text);
    write_reports(true);
    fs::remove_all(options_.out / k_work);
    lock_.reset();
    fs::remove(options_.out / "nilas.log");
    tell_end();
    if (!no_pictures_.empty()) std::cerr << "warning: " << no_pictures_ << "\n";
    return stopped ? exit_interrupted : exit_done;
  }

  void tell_end() const {
    if (options_.json) std::cout << json_.dump(1, ' ', false, Json::error_handler_t::replace) << std::endl;
    const std::vector<Comparison> comparisons = compare_solvers(report_.rows);
    for (const auto& one : comparisons) tell(headline(one) + "\n");
    if (report_.dropped.size() > plan_.dropped.size())
      tell(fmt::format("left out for lack of time: {}\n", dropped_text(report_)));
    tell(fmt::format("{}; {}\n", report_.status, (options_.out / "compare.html").string()));
  }

  using Json = nlohmann::ordered_json;
  std::function<bool()> stop_;
  ProblemStudyOptions options_;
  std::vector<StudyFile> files_;
  std::optional<RunLock> lock_;
  std::optional<OutputFile> table_;
  StudyPlan plan_;
  StudyReport report_;
  std::set<RunKey> done_;
  Json json_;
  std::string no_pictures_;
  double started_ = steady_seconds(), wall_before_ = 0, page_written_ = 0;
  std::size_t stored_ = 0;  ///< rows of earlier sessions
  std::size_t ended_ = 0, last_mark_ = 0;
};

}  // namespace

int run_problem_study(const ProblemStudyOptions& options, const std::function<bool()>& stop) {
  return Study(options, stop).execute();
}

}  // namespace nilas
