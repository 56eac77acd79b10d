#pragma once
/// The means of a load over the two halves of its window, which show a load that is not steady.
#include <optional>
#include <vector>

namespace nilas::output {

/// A mean and the half width of its error for about 95 % of runs [N or N m].
struct HalfMean {
  double mean = 0, half_width = 0;
};

struct HalfMeans {
  HalfMean first, second;

  /// Whether the means differ by more than both half widths together, and by at least a hundredth of the larger.
  bool differ() const;
};

/// The means over the halves of a series, each with the error of its own half. `ice_broke`: as in component_load().
/// Empty where the halves have too few values for such an error.
std::optional<HalfMeans> half_means(const std::vector<double>& series, bool ice_broke);

}  // namespace nilas::output
