#include "apps/report/run/run_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/base/json_text.h"
#include "core/output/run/run_folder.h"
#include "core/scene/read/read_scene.h"

namespace nilas::report {

namespace {

namespace fs = std::filesystem;

std::string folder_name(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return (whole.has_filename() ? whole.filename() : whole.parent_path().filename()).string();
}

void read_summary(RunData& run) {
  const fs::path file = output::RunFolder::summary_file(run.folder);
  if (!fs::exists(file)) {
    run.gaps.push_back({"Figures of the whole run",
                        "There is no summary.json, so the run was killed, still goes on, or was not copied whole. The "
                        "loads are computed from the tables instead."});
    return;
  }
  run.summary = nlohmann::ordered_json::parse(json_file_text(file), nullptr, false);
  if (run.summary.is_object()) return;
  run.summary = nullptr;
  run.gaps.push_back(
      {"Figures of the whole run", "summary.json is cut or damaged. The loads are computed from the tables instead."});
}

void read_table(RunData& run, const char* file, RunTable& table) {
  if (fs::exists(run.folder / file))
    run.attempt("The table " + std::string(file), [&] { table = RunTable(run.folder / file); });
}

/// Notes the tables that the scene asks for and the folder lacks.
void note_missing(RunData& run) {
  const auto demand = [&](const char* file, bool wanted) {
    if (wanted && !fs::exists(run.folder / file))
      run.gaps.push_back({"The table " + std::string(file),
                          "The file is not in the folder, so what it holds is left out. Copy the whole folder."});
  };
  demand("steps.csv", true);
  demand("vessel.csv", run.scene && run.scene->vessel.has_value());
  demand("events.csv", run.scene && run.scene->fracture && run.scene->fracture->cuts_floes());
}

/// Columns that hold words. Some of these may look like numbers, such as a hash of digits alone.
constexpr std::array<std::string_view, 4> k_words{"status", "state_hash", "kind", "pieces"};

/// Notes columns in which some cells are no number. A column without any number holds words, too.
void note_no_numbers(RunData& run) {
  const auto check = [&](const char* file, const RunTable& table) {
    std::string columns;
    std::size_t all = 0;
    for (const std::string& name : table.names()) {
      if (std::find(k_words.begin(), k_words.end(), name) != k_words.end()) continue;
      const std::vector<double>& values = table[name];
      const auto bad = static_cast<std::size_t>(
          std::count_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); }));
      if (bad == 0 || bad == values.size()) continue;
      columns += (columns.empty() ? "" : ", ") + name;
      all += bad;
    }
    if (all == 0) return;
    run.gaps.push_back(
        {"The table " + std::string(file), fmt::format("{} {} no finite number and left out of graphs, in {}.", all,
                                                       all == 1 ? "cell is" : "cells are", columns)});
  };
  check("vessel.csv", run.vessel);
  check("structures.csv", run.structures);
  check("steps.csv", run.steps);
  check("events.csv", run.events);
}

/// Notes the tables that end before the longest.
void note_cut(RunData& run) {
  const auto check = [&](const char* file, const RunTable& table) {
    if (table.rows() == 0) return;
    if (table.rows() < run.steps_done())
      run.gaps.push_back(
          {"The table " + std::string(file),
           fmt::format("It ends at {:.6g} s, before the run's last step at {:.6g} s: it was cut, damaged "
                       "or is still being written. What it holds is shown.",
                       table.time().back(), run.times().back())});
  };
  check("vessel.csv", run.vessel);
  check("structures.csv", run.structures);
  check("steps.csv", run.steps);
  if (run.summary.contains("steps") && run.summary.at("steps").is_number_integer() &&
      run.summary.at("steps").get<std::size_t>() > run.steps_done())
    run.gaps.push_back({"Steps of the run", fmt::format("The tables hold {} of the {} steps that summary.json counts.",
                                                        run.steps_done(), run.summary.at("steps").get<std::size_t>())});
}

}  // namespace

double RunData::step() const {
  const auto& time = times();
  if (time.empty()) return 0;
  if (time.size() > 1) return (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  return scene ? scene->time.step : time.front();
}

double RunData::start() const {
  if (scene) return scene->time.start;
  return times().empty() ? 0 : times().front() - step();
}

const std::vector<double>& RunData::times() const {
  static const std::vector<double> k_none;
  const std::vector<double>* longest = &k_none;
  for (const RunTable* table : std::array{&vessel, &structures, &steps})
    if (table->rows() > longest->size()) longest = &table->time();
  return *longest;
}

bool RunData::broke_before(double time) const {
  return events.rows() > 0 && std::any_of(events.time().begin(), events.time().end(),
                                          [&](double broke) { return broke - 0.5 * step() < time; });
}

bool RunData::attempt(const std::string& what, const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const InputError& fault) {
    gaps.push_back({what, std::string(fault.what()) + "."});
  } catch (const FileError& fault) {
    if (unreadable.empty()) unreadable = fault.what();
    gaps.push_back({what, std::string(fault.what()) + "."});
  } catch (const SceneError& fault) {
    gaps.push_back({what, std::string(fault.what()) + "."});
  } catch (const nlohmann::json::exception& fault) {
    gaps.push_back({what, std::string("summary.json is of another version: ") + fault.what() + "."});
  }
  return false;
}

RunData read_run(const fs::path& folder) {
  demand_there(folder, "run folder");
  if (!is_folder(folder)) throw InputError(folder.string() + ": is a file; a report needs the folder of a run");
  RunData run;
  run.folder = folder;
  run.name = folder_name(folder);
  const fs::path scene_file = output::RunFolder::scene_file(folder);
  if (!fs::exists(scene_file) && !fs::exists(folder / "steps.csv") && !fs::exists(folder / "vessel.csv"))
    throw InputError(folder.string() + ": is no run folder, since it has neither scene.xml nor tables");
  run.attempt("The scene", [&] { run.scene = scene::read_scene(scene_file); });
  read_summary(run);
  read_table(run, "vessel.csv", run.vessel);
  read_table(run, "structures.csv", run.structures);
  read_table(run, "steps.csv", run.steps);
  read_table(run, "events.csv", run.events);
  note_missing(run);
  note_cut(run);
  note_no_numbers(run);
  if (run.times().empty() && !run.unreadable.empty()) throw FileError(run.unreadable);
  if (run.times().empty())
    throw InputError(folder.string() +
                     ": there is nothing to report, since no table of the folder holds a step. The run was killed "
                     "before its first step ended, or its tables were not copied");
  return run;
}

}  // namespace nilas::report
