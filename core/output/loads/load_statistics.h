#pragma once
/// Statistics of one load channel over a run.
#include <vector>

namespace nilas::output {

struct LoadStatistics {
  double mean = 0;
  double std = 0;  ///< root of the mean squared deviation from `mean`
  double max = 0;  ///< largest absolute value
  double p99 = 0;  ///< 99th percentile of the absolute values, linear between neighbours
};

/// Statistics of a series; all zero for an empty one.
LoadStatistics load_statistics(const std::vector<double>& series);

}  // namespace nilas::output
