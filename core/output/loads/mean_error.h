#pragma once
/// The error of the mean of one finite, correlated series. Method and sources: docs/theory/load-error.md.
#include <vector>

namespace nilas::output {

/// Standard error of a mean.
struct MeanError {
  double standard_error = 0;
  double freedom = 0;  ///< degrees of freedom of the estimate; 0: too few values

  /// Half width of the two-sided 95 % interval by Student's t; infinite for too few values.
  double half_width() const;
};

/// Error from fluctuations with a memory shorter than a 64th of the series. It uses second differences between
/// neighbouring batches, and takes the smallest result of 16, 32 and 64 batches. Slow changes are no error of the mean
/// over just this time; a constant or a steady rise gives 0.
MeanError mean_error(const std::vector<double>& series);

/// Error of a series with a longer memory, such as the load of breaking ice: the scatter of the means of 8 batches
/// about the straight line through them. Only a steady change is excluded.
MeanError slow_mean_error(const std::vector<double>& series);

/// Error of the mean from the means of several runs.
MeanError mean_error_of_runs(const std::vector<double>& means);

}  // namespace nilas::output
