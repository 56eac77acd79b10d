#pragma once
/// Peaks of a load.
#include <vector>

namespace nilas::output {

/// The largest absolute value of a load, in three forms; values keep their signs.
struct Peak {
  double raw = 0, raw_time = 0;  ///< mean over one step, time at its end; for rigid contacts it depends on the step
  double filtered = 0, filtered_time = 0;  ///< mean over the filter time, time at the interval's end
  double filter = 0;  ///< filter time: as requested, but at least a step and at most the series [s]
  /// Impulse of the event around the raw peak. The event consists of consecutive steps whose load differs from the mean
  /// by at least a tenth of the peak's difference [N s or N m s].
  double event_impulse = 0;
  double event_from = 0, event_to = 0;  ///< [s]
};

/// The peak of `series`, the means over steps of length h [s], the first of which begins at t0 [s]. `filter`: averaging
/// time [s], at least a step. The mean over the filter time is exact for loads that are constant within steps.
Peak peak_of(const std::vector<double>& series, double t0, double h, double filter);

/// Averaging time of peaks for a hull of this length [m]: 0.2 s at 100 m, by Froude's law for others [s].
double default_peak_filter(double length);

/// Share of the sum of absolute values that the largest 1 % of them contribute; 0 where all are zero.
double share_of_largest_percent(const std::vector<double>& series);

}  // namespace nilas::output
