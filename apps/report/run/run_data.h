#pragma once
/// What a run folder holds, as far as it can be read.
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/report/run/run_table.h"
#include "core/scene/scene.h"

namespace nilas::report {

/// Something that the report cannot show, and why, in whole sentences.
struct Gap {
  std::string what, why;
};

struct RunData {
  std::filesystem::path folder;
  std::string name;                            ///< of the folder
  nlohmann::ordered_json summary;              ///< null where there is none
  std::optional<scene::Scene> scene;           ///< empty where this version cannot read it
  RunTable vessel, structures, steps, events;  ///< without columns where there is no such file
  std::vector<Gap> gaps;
  std::string unreadable;  ///< what is wrong with the first file that could not be read; empty where all could

  bool has_vessel() const { return vessel.has("ice_resistance_N"); }
  /// Length of the steps [s]; 0 with fewer than one step.
  double step() const;
  /// Start of the run [s].
  double start() const;
  std::size_t steps_done() const { return times().size(); }
  /// Ends of the steps [s], from the table that has the most of them.
  const std::vector<double>& times() const;
  /// Whether a floe broke before this time [s].
  bool broke_before(double time) const;
  /// Runs `work`; where a file cannot be read or lacks something, notes a gap in its place. Returns whether it went
  /// well.
  bool attempt(const std::string& what, const std::function<void()>& work);
};

/// Reads a run folder. Throws FileError where there is no such folder or where its steps cannot be read, and InputError
/// where it holds no run or a run without a step.
RunData read_run(const std::filesystem::path& folder);

}  // namespace nilas::report
