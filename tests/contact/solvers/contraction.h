#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

namespace nilas::test {

/// The mean ratio of successive residuals over the last quarter of the sweeps.
inline double late_contraction(const std::vector<double>& history) {
  const std::size_t sweeps = history.size(), span = sweeps / 4;
  return std::pow(history.back() / history[sweeps - 1 - span], 1.0 / static_cast<double>(span));
}

}  // namespace nilas::test
