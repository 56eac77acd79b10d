#include "apps/compare/scenes/run/run_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "apps/compare/workshop/json_store.h"
#include "apps/compare/workshop/special_numbers.h"
#include "core/base/csv.h"
#include "core/base/error.h"
#include "core/base/statistics.h"
#include "core/output/file/flush.h"
#include "core/sim/account/step_record.h"

namespace nilas::compare {

namespace {

/// The last line of a log that is no warning, cut to 300 characters.
std::string last_words(const std::filesystem::path& log) {
  std::ifstream in(log);
  std::string line, last;
  while (std::getline(in, line))
    if (!line.empty() && line.find("warning: ") != 0) last = line;
  constexpr std::size_t k_longest = 300;
  return last.substr(0, k_longest);
}

void judge_exit(const ChildResult& ended, const std::filesystem::path& log, RunResult& result) {
  if (ended.stopped) {
    result.status = "interrupted";
  } else if (ended.timed_out) {
    result.status = "budget";
    result.cause = fmt::format("the budget ended it after {:.3g} s", ended.wall_s);
  } else if (ended.exit_code > k_exit_signal && ended.exit_code != exit_interrupted) {
    result.status = "crashed";
    result.cause = fmt::format("signal {}", ended.exit_code - k_exit_signal);
  } else if (ended.exit_code == k_exit_not_started) {
    result.status = "failed";
    result.cause = "the program cannot be started again";
  } else if (ended.exit_code != 0) {
    result.status = "failed";
    result.cause = fmt::format("exit code {}: {}", ended.exit_code, last_words(log));
  } else {
    result.status = "done";
  }
}

}  // namespace

double RunResult::ms_per_step() const {
  double ms = 0;
  for (int p = 0; p < sim::k_num_phases; ++p)
    if (static_cast<sim::Phase>(p) != sim::Phase::output) ms += summary.phase_ms[p];
  // the phases are timed by the wall clock, so the time that the run waited is removed in proportion
  return cpu_s > 0 && cpu_s < wall_s ? ms * cpu_s / wall_s : ms;
}

double RunResult::compute_per_second() const {
  const double length = summary.real_time_factor * summary.wall_s;
  return length > 0 ? 1e-3 * ms_per_step() * summary.steps / length : k_unknown;
}

Json to_json(const RunResult& result) {
  return {{"status", result.status},
          {"cause", result.cause},
          {"cpu_s", result.cpu_s},
          {"wall_s", result.wall_s},
          {"stabilisation_J", result.stabilisation_J},
          {"penetration_mean_m", result.penetration_mean_m},
          {"first_steps_ms", result.first_steps_ms},
          {"summary", output::to_json(result.summary)}};
}

RunResult run_result_from(const Json& json) {
  RunResult result;
  result.status = json.at("status");
  result.cause = json.at("cause");
  result.cpu_s = json.at("cpu_s");
  result.wall_s = json.at("wall_s");
  const auto number = [&](const char* name) {
    return json.at(name).is_number() ? json.at(name).get<double>() : k_unknown;
  };
  result.stabilisation_J = number("stabilisation_J");
  result.penetration_mean_m = number("penetration_mean_m");
  result.first_steps_ms = number("first_steps_ms");
  result.summary = output::run_summary_from(json.at("summary"));
  return result;
}

RunResult read_run(const std::filesystem::path& folder, const std::filesystem::path& log, const ChildResult& ended) {
  RunResult result;
  result.cpu_s = ended.cpu_s;
  result.wall_s = ended.wall_s;
  judge_exit(ended, log, result);
  result.summary = output::read_run_summary(folder);
  if (result.done() && !result.summary.exists()) {
    result.status = "failed";
    result.cause = "the run left no summary.json";
  }
  // a run that was ended while it began leaves a file without its header
  if (!std::filesystem::exists(folder / "steps.csv") || std::filesystem::file_size(folder / "steps.csv") == 0)
    return result;
  const auto columns = csv_columns(folder / "steps.csv", {"stabilisation_J", "penetration_mean_m"});
  if (!columns[0].empty()) result.stabilisation_J = columns[0].back();
  result.penetration_mean_m = mean_of(columns[1]);
  return result;
}

void put_on_disk(const std::filesystem::path& folder) {
  output::UnflushedFiles files(true);
  for (const char* file : {"ice_load.csv", "bodies.csv"}) files.add(folder / file);
  files.flush();
  output::flush_names(folder.parent_path());
}

void thin_out(const std::filesystem::path& folder) {
  constexpr std::array k_kept{"scene.xml", "inputs", "nilas.log", "summary.json", "bodies.csv", "ice_load.csv"};
  std::error_code error;
  std::vector<std::filesystem::path> gone;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (std::find(k_kept.begin(), k_kept.end(), entry.path().filename()) == k_kept.end()) gone.push_back(entry.path());
  for (const auto& path : gone) std::filesystem::remove_all(path, error);
}

StepTimes read_step_times(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder / "steps.csv") || std::filesystem::file_size(folder / "steps.csv") == 0)
    return {};
  std::vector<std::string> names{"time_s", "ms_solver", std::string("ms_") + sim::to_string(sim::Phase::output)};
  for (int p = 0; p < sim::k_num_phases; ++p)
    if (static_cast<sim::Phase>(p) != sim::Phase::output && static_cast<sim::Phase>(p) != sim::Phase::solver)
      names.push_back(std::string("ms_") + sim::to_string(static_cast<sim::Phase>(p)));
  const auto columns = csv_columns(folder / "steps.csv", names);
  StepTimes times{columns[0], columns[1], columns[1], columns[2]};
  for (std::size_t c = 3; c < columns.size(); ++c)
    for (std::size_t k = 0; k < times.ms.size(); ++k) times.ms[k] += columns[c][k];
  return times;
}

}  // namespace nilas::compare
