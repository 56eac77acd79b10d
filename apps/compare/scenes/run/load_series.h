#pragma once
/// The load of the ice on the vessel at every step of a run, and what it amounts to over a window that runs with other
/// steps share.
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/output/loads/load_statistics.h"

namespace nilas {

/// Along the course, positive astern, and across it, positive to port.
constexpr std::array k_course_channels{"ice_resistance_N", "ice_side_N"};

struct LoadSeries {
  double start = 0;                                                 ///< of the first step [s]
  std::vector<double> end;                                          ///< of each step [s]
  std::array<std::vector<double>, k_course_channels.size()> loads;  ///< over each step [N]
};

/// Writes those columns of a run's vessel.csv into ice_load.csv beside it; nothing where there is no vessel.csv. Throws
/// FileError.
void keep_load_series(const std::filesystem::path& run_folder);

/// Of ice_load.csv; empty where the run left none. `start`: of the run [s]. Throws FileError.
LoadSeries read_load_series(const std::filesystem::path& run_folder, double start);

/// Of a channel between two times [s]. A load is constant over its step, so that the mean over a window does not depend
/// on where the steps end; deviation, largest and 99 % are of the steps whose middle lies within. NaN where the run has
/// no such step.
LoadStatistics statistics_over(const LoadSeries& series, std::size_t channel, double from, double to);

}  // namespace nilas
