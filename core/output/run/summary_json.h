#pragma once
/// summary.json: one run in one object. Keys: docs/reference/outputs.md.
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "core/output/loads/run_statistics.h"
#include "core/sim/account/step_record.h"

namespace nilas {

/// What only the program that ran the scene knows.
struct SummaryInput {
  std::string status = "done";  ///< done, failed, interrupted ...
  std::string ended_early;      ///< why a run that is done did not reach its end time, or empty
  int exit_code = 0;
  double wall_s = 0;  ///< of the whole run [s]
  std::uint64_t seed = 0;
  int threads = 1;
  std::string machine;
  std::map<std::string, std::string> versions;  ///< library or tool: version
  double ice_mass_end = 0;                      ///< of free floes [kg]
  long floes_end = 0;
  double crushed_mass = 0;   ///< of ice that the hull and bodies took the place of [kg]
  double brash_mass = 0;     ///< of ice that broke too small to follow [kg]
  double extruded_mass = 0;  ///< of crushed ice that was cut out of its floes [kg]
  std::optional<TwinStatistics> twins;
  std::optional<IceLoad> ice_load;  ///< of a vessel
};

nlohmann::ordered_json summary_json(const RunInfo& info, const RunStatistics& statistics, const SummaryInput& input);

/// Writes it through a rename, so a reader never finds half of it. Throws FileError.
void write_summary_json(const std::filesystem::path& path, const nlohmann::ordered_json& summary);

}  // namespace nilas
