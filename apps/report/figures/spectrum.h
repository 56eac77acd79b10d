#pragma once
/// The spectrum of a load: Welch's method. docs/theory/report.md
#include <optional>
#include <vector>

namespace nilas::report {

/// One-sided spectral density of the deviation from the mean. Its sum times `resolution` is the mean square of the
/// windowed deviation, which estimates the variance.
struct Spectrum {
  std::vector<double> frequency;  ///< [Hz], from 0 in steps of the resolution
  std::vector<double> density;    ///< square of the series' unit per Hz
  double resolution = 0;          ///< [Hz]
  std::size_t segment = 0;        ///< steps in each segment
  std::size_t segments = 0;       ///< number of segments, each half over the next
  double low = 0, high = 0;       ///< the true density is within these factors of the estimate, 95 %
};

/// The spectrum of a series of means over steps of length h [s]. Segments have a Hann window and are the longest power
/// of two of which at least eight fit. Empty for a series of fewer than 72 steps.
std::optional<Spectrum> spectrum_of(const std::vector<double>& series, double h);

/// The same with segments of this many steps, a power of two, of which at least one fits.
Spectrum spectrum_of(const std::vector<double>& series, double h, std::size_t segment);

}  // namespace nilas::report
