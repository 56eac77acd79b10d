#pragma once
/// The ice of a run at a time, for drawings.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/math.h"

namespace nilas::report {

struct IceFrame {
  double t = 0;                             ///< time of the frame [s]
  std::vector<std::vector<Vec3>> outlines;  ///< upper outlines of floes and of pieces of broken ones, in G [m]
  std::vector<std::int64_t> ids;            ///< of these floes
};

/// A stored frame of the ice.
struct IceFrameFile {
  double t = 0;  ///< [s]
  std::filesystem::path file;
};
/// The stored frames of a run's ice, as trajectory.pvd lists them; none without that file. Throws FileError or
/// InputError for a list that cannot be read.
std::vector<IceFrameFile> ice_frame_files(const std::filesystem::path& run_folder);

/// The ice of a stored frame. Throws FileError or InputError for a file that cannot be read.
IceFrame read_ice_frame(const IceFrameFile& frame);

/// The ice in the stored frame of a run's trajectory that is nearest to t [s]; nothing if the run stored none. Throws
/// FileError or InputError for a file that cannot be read.
std::optional<IceFrame> ice_near(const std::filesystem::path& run_folder, double t);

}  // namespace nilas::report
