#pragma once
/// The load of the ice on the vessel at every step of a run, and its statistics over a window that runs with other
/// steps share.
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/output/loads/load_statistics.h"

namespace nilas::compare {

/// The channels of the ice load along the course, positive astern, and across it, positive to port.
constexpr std::array k_course_channels{"ice_resistance_N", "ice_side_N"};

struct LoadSeries {
  double start = 0;                                                 ///< start of the first step [s]
  std::vector<double> end;                                          ///< end of each step [s]
  std::array<std::vector<double>, k_course_channels.size()> loads;  ///< mean load over each step [N]
};

/// Writes these columns of a run's vessel.csv into ice_load.csv in the same folder; nothing if there is no vessel.csv.
/// Throws FileError.
void keep_load_series(const std::filesystem::path& run_folder);

/// Reads ice_load.csv; empty if the run left none. `start`: start time of the run [s]. Throws FileError.
LoadSeries read_load_series(const std::filesystem::path& run_folder, double start);

/// The statistics of a channel between two times [s]. A load is taken as constant over its step, so that the mean does
/// not depend on where the steps end. The standard deviation, the largest and the 99 % load are of the steps with their
/// middle in the window. NaN if the run has no such step.
output::LoadStatistics statistics_over(const LoadSeries& series, std::size_t channel, double from, double to);

}  // namespace nilas::compare
