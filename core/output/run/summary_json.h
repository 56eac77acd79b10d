#pragma once
/// summary.json: one run in one object. Keys: docs/reference/outputs.md.
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/bodies/module.h"
#include "core/output/loads/run_statistics.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

/// Facts about a run that only the calling program knows.
struct SummaryInput {
  std::string status = "done";  ///< done, failed, interrupted ...
  std::string ended_early;      ///< reason why a completed run did not reach its end time, or empty
  int exit_code = 0;
  double wall_s = 0;       ///< wall time of the whole run [s]
  double processor_s = 0;  ///< processor time of the whole run, on all threads [s]
  double resuming_s = 0;   ///< wall time in which later sessions of the run built the scene again [s]
  std::uint64_t seed = 0;
  int threads = 1;
  std::string machine;
  std::map<std::string, std::string> versions;  ///< version by library or tool
  double ice_mass_end = 0;                      ///< mass of the free floes [kg]
  long floes_end = 0;
  double crushed_mass = 0;   ///< mass of ice that hull and bodies crushed [kg]
  double brash_mass = 0;     ///< mass of pieces too small to follow [kg]
  double extruded_mass = 0;  ///< mass of crushed ice that was cut out of its floes [kg]
  /// Figures of the run by the modules that give them, with the modules' names.
  std::vector<std::pair<std::string, std::vector<bodies::RunFigure>>> figures;
  std::optional<TwinStatistics> twins;
  std::optional<IceLoad> ice_load;  ///< present with a vessel
};

nlohmann::ordered_json summary_json(const sim::RunInfo& info, const RunStatistics& statistics,
                                    const SummaryInput& input);

/// Writes the summary through a temporary file and a rename, so that readers never see an incomplete file. Throws
/// FileError.
void write_summary_json(const std::filesystem::path& path, const nlohmann::ordered_json& summary);

}  // namespace nilas::output
