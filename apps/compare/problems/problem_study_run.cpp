#include "apps/compare/problems/problem_study_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/compare/workshop/json_store.h"
#include "apps/compare/workshop/special_numbers.h"
#include "core/base/error.h"

namespace nilas::compare {

namespace {

constexpr double k_grace_s = 2,
                 k_grace_factor = 1.5;  // for the start, the repeated solves and solvers that seldom look at the clock

std::string first_line(const std::string& text) {
  const std::string line = text.substr(0, text.find('\n'));
  const std::string label = "error: ";
  return line.rfind(label, 0) == 0 ? line.substr(label.size()) : line;
}

/// The JSON that `nilas solve` printed. Other libraries may print before it.
Json result_in(const std::string& printed) {
  const std::size_t begin = printed.rfind("{\n  \"problem\"");
  if (begin == std::string::npos) return Json();
  Json result = Json::parse(printed.substr(begin), nullptr, false);
  return result.is_object() ? result : Json();
}

double number_in(const Json& result, const char* name) {
  const auto found = result.find(name);
  return found != result.end() && found->is_number() ? found->get<double>() : k_unknown;
}

void take(const Json& result, StudyRow& row) {
  row.claimed = result.value("claimed", "");
  row.iterations = result.value("iterations", 0);
  row.seconds = number_in(result, "seconds");
  row.open = result.value("open", 0);
  row.sticking = result.value("sticking", 0);
  row.sliding = result.value("sliding", 0);
  row.message = result.value("message", "");
  for (const auto& column : contact::residual_columns()) row.residuals.*column.member = number_in(result, column.name);
}

RunOutcome outcome_of(const StudyRow& row, double limit_s) {
  const bool late = row.seconds > limit_s;
  if (row.residuals.law_map_m_s <= row.tolerance && !late) return RunOutcome::solved;
  if (row.claimed == "numerical_error") return RunOutcome::numerical_error;
  // a solver that watches the clock may end a moment before the limit
  constexpr double k_nearly = 0.99;
  if (late || (row.claimed == "iteration_limit" && row.seconds >= k_nearly * limit_s)) return RunOutcome::time_limit;
  if (row.claimed == "iteration_limit") return RunOutcome::iteration_limit;
  return row.claimed == "converged" ? RunOutcome::above_tolerance : RunOutcome::stalled;
}

}  // namespace

ChildTask task_of(const StudyFile& file, const StudyRun& run, double limit_s, const std::filesystem::path& output,
                  const std::filesystem::path& log) {
  static const std::string program = own_program().string();
  return {{program, "solve", file.path.string(), "--solver", run.solver, "--law", run.law, "--tolerance",
           fmt::format("{}", run.tolerance), "--max-time", fmt::format("{}", limit_s), "--max-iterations",
           std::to_string(k_study_iterations), "--repeat", std::to_string(k_study_repeats), "--json"},
          output,
          log,
          k_grace_factor * limit_s + 2 * file.reading_s + k_grace_s};
}

StudyRow judge(const StudyFile& file, const StudyRun& run, double limit_s, const ChildResult& ended,
               const std::string& printed, const std::string& logged) {
  StudyRow row = row_of(file, run);
  row.wall = ended.wall_s;
  row.cpu = ended.cpu_s;
  row.exit_code = ended.exit_code;
  const Json result = result_in(printed);
  if (ended.timed_out) {
    row.outcome = RunOutcome::time_limit;
    row.message = "the process was ended at its time limit";
  } else if (ended.exit_code > k_exit_signal) {
    row.outcome = RunOutcome::crashed;
    row.message = fmt::format("signal {}", ended.exit_code - k_exit_signal);
  } else if (result.is_object()) {
    take(result, row);
    row.outcome = outcome_of(row, limit_s);
  } else if (ended.exit_code == k_exit_not_started) {
    throw FileError(own_program().string() + ": the program cannot be started again");
  } else if (logged.empty()) {
    throw FileError("the result of a run is incomplete; the disk may be full");
  } else {
    const bool input = ended.exit_code == exit_bad_input || ended.exit_code == exit_file;
    row.outcome = input ? RunOutcome::unreadable : RunOutcome::crashed;
    row.message = first_line(logged);
  }
  std::replace(row.message.begin(), row.message.end(), '\n', ' ');
  return row;
}

}  // namespace nilas::compare
