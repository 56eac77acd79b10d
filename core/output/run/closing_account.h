#pragma once
/// What a run says at its end.
#include <filesystem>
#include <optional>
#include <string>

#include "core/output/loads/run_statistics.h"

namespace nilas {

/// What became of ice that can break.
struct BrokenIce {
  long floes = 0, floes_end = 0;
  double crushed_mass = 0, brash_mass = 0, extruded_mass = 0;  ///< [kg]
  bool crushes = false;
};

/// Wall-clock time, where it went per phase, the worst solver residual, penetration and energy imbalance, the ice
/// load and the tow force over the window, loads on structures, the path of the outputs; of ice that can break what
/// became of it, of twins when they part. Lines of at most 80 columns, the path's excepted. `wall_s`: of the whole run.
std::string closing_account(const RunStatistics& statistics, double wall_s, const std::filesystem::path& outputs,
                            const std::optional<BrokenIce>& ice = {}, const TwinStatistics* twins = nullptr,
                            const std::optional<IceLoad>& ice_load = {});

}  // namespace nilas
