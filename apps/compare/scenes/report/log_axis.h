#pragma once
/// Logarithmic axes of pictures.
#include <algorithm>
#include <limits>
#include <vector>

namespace nilas::compare {

/// The smallest and largest value that is shown.
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// The factor between what is shown and the end of an axis.
constexpr double k_axis_room = 1.6;

struct LogAxis {
  double low = 0, high = 0;  ///< ends, both above 0
  std::vector<double> tics;  ///< values with a label, some of them beyond the ends

  /// The place of a value as a share of the axis: 0 at its low end, 1 at its high end.
  double share(double value) const;
  double at_share(double share) const;  ///< the value at a place
};

/// The axis with room around the extent, whose values are above 0. The labels are at 1, 2 and 5 of each decade if there
/// are few decades, else at the decades.
LogAxis log_axis(const Extent& extent);

}  // namespace nilas::compare
