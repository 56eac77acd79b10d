#pragma once
/// The account that a run prints at its end.
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/bodies/module.h"
#include "core/output/loads/run_statistics.h"

namespace nilas::output {

/// Losses of ice that can break.
struct BrokenIce {
  long floes = 0, floes_end = 0;
  double crushed_mass = 0, brash_mass = 0, extruded_mass = 0;  ///< [kg]
  bool crushes = false;
};

/// The end of a run, as only the calling program knows it.
struct RunEnding {
  double wall_s = 0;       ///< wall-clock time of the whole run [s]
  double processor_s = 0;  ///< processor time of the whole run, on all threads [s]
  double resuming_s = 0;   ///< wall-clock time in which later sessions built the scene again [s]
  /// Figures of the run by the modules that give them, with the modules' names.
  std::vector<std::pair<std::string, std::vector<bodies::RunFigure>>> figures = {};
  std::string interrupted = {};  ///< when the run was interrupted and how to continue it; empty: it was not
};

/// The account as lines of at most 80 columns, except for the path. It contains wall-clock and processor time, with a
/// sentence where the machine was busy with other work, time per phase, the worst solver residual, penetration and
/// energy error, the ice load and tow force over the window, loads on structures, and the path of the outputs. It also
/// contains the figures that modules give, such as the advance of a turning circle, the losses of ice that can break,
/// and the horizon of perturbed runs (`twins`).
std::string closing_account(const RunStatistics& statistics, const RunEnding& ending,
                            const std::filesystem::path& outputs, const std::optional<BrokenIce>& ice = {},
                            const TwinStatistics* twins = nullptr, const std::optional<IceLoad>& ice_load = {});

}  // namespace nilas::output
