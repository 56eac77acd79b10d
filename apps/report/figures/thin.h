#pragma once
/// Series with fewer points, for drawings.
#include <vector>

#include "apps/report/figures/curve.h"

namespace nilas::report {

/// Number of points that a page has of a series at most.
inline constexpr std::size_t k_most_points = 1500;

/// The curve of a series with at most `most` points. Where the series is longer, each point is the mean over
/// consecutive steps of equal number, with their least and largest value as range, so no peak is lost. Values that are
/// not finite are left out of a mean; a point without any is NaN.
Curve thinned(const std::string& name, const std::vector<double>& x, const std::vector<double>& y, double factor = 1,
              std::size_t most = k_most_points);

}  // namespace nilas::report
