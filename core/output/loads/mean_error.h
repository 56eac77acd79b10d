#pragma once
/// How well the mean of one finite, correlated series is known. Method and sources: docs/theory/load-error.md.
#include <vector>

namespace nilas {

/// Standard error of a mean; `freedom`: degrees of freedom that it was estimated with.
struct MeanError {
  double standard_error = 0;
  double freedom = 0;  ///< 0: too few values to say

  /// Half width of the two-sided 95 % interval, by Student's t; infinite where too few values say nothing.
  double half_width() const;
};

/// Of the part of a series that forgets itself within a 64th of it: from second differences between neighbouring
/// batches, the least over 16, 32 and 64 batches. What changes slowly is no error of the mean over just this time, and
/// a constant or a steady rise gives 0.
MeanError mean_error(const std::vector<double>& series);

/// Of a series that remembers for longer than that, as the load of ice that breaks does: what the means of 8 batches
/// scatter by about the straight line through them. Of slow changes only a steady one is left out then.
MeanError slow_mean_error(const std::vector<double>& series);

/// From the means of several runs.
MeanError mean_error_of_runs(const std::vector<double>& means);

}  // namespace nilas
