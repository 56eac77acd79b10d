#pragma once
/// Peaks of a load, and what they are worth.
#include <vector>

namespace nilas {

/// The largest absolute value of a load, in three forms; values keep their signs.
struct Peak {
  double raw = 0, raw_time = 0;  ///< mean over one step, at the step's end: of rigid contacts it depends on the step
  double filtered = 0, filtered_time = 0;  ///< mean over the filter time, at that interval's end
  double filter = 0;  ///< that time: what was asked, but a step at least and the series at most [s]
  /// Impulse of the event around the raw peak: of the steps in a row whose load lies beyond the mean by a tenth of what
  /// the peak does [N s or N m s].
  double event_impulse = 0;
  double event_from = 0, event_to = 0;  ///< [s]
};

/// `series`: means over steps of length h [s], the first of which begins at t0 [s]. `filter`: averaging time [s]; where
/// it is shorter than a step, a step. The mean over the filter time is exact for loads that are constant within steps.
Peak peak_of(const std::vector<double>& series, double t0, double h, double filter);

/// Averaging time of peaks for a hull of this length [m]: 0.2 s at 100 m, by Froude's law for others [s].
double default_peak_filter(double length);

/// The part of the sum of absolute values that the largest 1 % of them hold; 0 where all are zero.
double share_of_largest_percent(const std::vector<double>& series);

}  // namespace nilas
