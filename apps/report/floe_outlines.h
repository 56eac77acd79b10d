#pragma once
/// The ice of a run at a time, for drawings.
#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/math.h"

namespace nilas::report {

struct IceFrame {
  double t = 0;                             ///< time of the frame [s]
  std::vector<std::vector<Vec3>> outlines;  ///< upper outlines of floes and of pieces of broken ones, in G [m]
};

/// The ice in the stored frame of a run's trajectory that is nearest to t [s]; nothing if the run stored none. Throws
/// FileError or InputError for a file that cannot be read.
std::optional<IceFrame> ice_near(const std::filesystem::path& run_folder, double t);

}  // namespace nilas::report
