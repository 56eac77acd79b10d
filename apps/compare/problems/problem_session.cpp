#include "apps/compare/problems/problem_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/compare/workshop/child.h"
#include "apps/compare/workshop/json_store.h"
#include "core/base/error.h"
#include "core/base/machine.h"
#include "core/output/run/claim_folder.h"
#include "core/output/text/console.h"

namespace nilas::compare {

namespace {

namespace fs = std::filesystem;

constexpr double k_usual_budget = 1200;  // [s]
constexpr const char* k_table = "compare.csv";

StudyFiles problem_study_files() {
  return {{k_problem_json, k_table}, [](const std::string& name) {
            static const std::set<std::string> names{k_problem_json, k_table, "compare.html", k_problem_work};
            const std::string part = ".part";  // a file that was being replaced when the study was killed
            const std::string whole = name.ends_with(part) ? name.substr(0, name.size() - part.size()) : name;
            return names.count(whole) > 0 || is_problem_picture_file(name);
          }};
}

fs::path usual_folder(const fs::path& problems) {
  const fs::path plain = fs::absolute(problems).lexically_normal();
  const std::string name = (plain.has_filename() ? plain : plain.parent_path()).filename().string();
  return output::dated_folder(name);
}

std::string machine() {
  const std::string processor = processor_text();
  return fmt::format("{}{}{}, {} cores", system_text(), processor.empty() ? "" : ", ", processor, usable_cores());
}

/// The options of an earlier study from its compare.json. `report` gets its time limit and its wall time.
ProblemStudyOptions stored_options(const ProblemStudyOptions& asked, ProblemReport& report) {
  const fs::path file = asked.resume / k_problem_json;
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
    throw InputError(file.string() + ": the file holds no study of stored problems");
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

/// The number of rows that were runs.
std::size_t runs_among(const std::vector<StudyRow>& rows) {
  return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [](const StudyRow& row) {
    return !row.solver.empty() && row.outcome != RunOutcome::not_applicable;
  }));
}

/// Fills the report with the figures of the plan and the options.
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

}  // namespace

ProblemTable::ProblemTable(const fs::path& file) : file_(file), disk_(std::make_unique<output::OutputFile>(file)) {
  disk_->append(study_header());
}

ProblemTable::ProblemTable(const fs::path& file, StoredRows stored)
    : file_(file), rows_(std::move(stored.rows)), disk_(std::make_unique<output::OutputFile>(file, "", stored.bytes)) {
  for (const auto& row : rows_) keys_.insert(key_of(row));
}

ProblemTable::RunKey ProblemTable::key_of(const StudyRow& row) {
  return {row.problem.name, row.solver, row.law, std::isnan(row.tolerance) ? 0 : row.tolerance};
}

void ProblemTable::add(const StudyRow& row) {
  disk_->append(study_line(row));
  keys_.insert(key_of(row));
  rows_.push_back(row);
}

void ProblemTable::close() {
  disk_->close();
  sort_study(rows_);
  std::string text = study_header();
  for (const auto& row : rows_) text += study_line(row);
  output::write_whole(file_, text);
}

double OpenedProblems::elapsed_s() const { return output::steady_seconds() - started_s; }

OpenedProblems open_problems(const ProblemStudyOptions& asked) {
  const double started_s = output::steady_seconds();
  const bool goes_on = !asked.resume.empty();
  ProblemReport report;
  const ProblemStudyOptions options = completed(goes_on ? stored_options(asked, report) : asked);
  const StudyChoice choice{options.solvers, options.laws, options.tolerances, report.limit_s};
  validate(choice);
  std::vector<StudyFile> files = survey(options.folder);
  StudyFolder folder = goes_on ? StudyFolder::open(options.out, problem_study_files())
                               : StudyFolder::claim(options.out, problem_study_files(), options.force);
  const fs::path csv = options.out / k_table;
  ProblemTable table = goes_on ? ProblemTable(csv, read_study(csv)) : ProblemTable(csv);
  fs::create_directories(options.out / k_problem_work);
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

}  // namespace nilas::compare
