#include "apps/report/figures/spectrum.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/base/statistics.h"

namespace nilas::report {

namespace {

std::vector<double> hann_window(std::size_t size) {
  std::vector<double> window(size);
  for (std::size_t k = 0; k < size; ++k)
    window[k] = 0.5 - 0.5 * std::cos(2 * k_pi * static_cast<double>(k) / static_cast<double>(size));
  return window;
}

/// Degrees of freedom of a mean over segments with a Hann window that overlap by half (Welch 1967): the squares of
/// neighbouring segments correlate by 1/36.
double degrees_of(std::size_t segments) {
  const auto count = static_cast<double>(segments);
  constexpr double k_neighbours = 1.0 / 36;
  return 2 * count / (1 + 2 * (1 - 1 / count) * k_neighbours);
}

}  // namespace

Spectrum spectrum_of(const std::vector<double>& series, double h, std::size_t segment) {
  NILAS_DEMAND(segment >= 2 && segment <= series.size() && h > 0);
  const double mean = mean_of(series);
  const std::vector<double> window = hann_window(segment);
  double window_square = 0;
  for (const double w : window) window_square += w * w;
  Spectrum spectrum;
  spectrum.segment = segment;
  spectrum.resolution = 1 / (static_cast<double>(segment) * h);
  spectrum.density.assign(segment / 2 + 1, 0);
  Eigen::FFT<double> transform;
  std::vector<double> part(segment);
  std::vector<std::complex<double>> image;
  for (std::size_t begin = 0; begin + segment <= series.size(); begin += segment / 2) {
    for (std::size_t k = 0; k < segment; ++k) part[k] = window[k] * (series[begin + k] - mean);
    transform.fwd(image, part);
    for (std::size_t k = 0; k < spectrum.density.size(); ++k) {
      const double sides = k == 0 || 2 * k == segment ? 1 : 2;
      spectrum.density[k] += sides * std::norm(image[k]) * h / window_square;
    }
    ++spectrum.segments;
  }
  for (std::size_t k = 0; k < spectrum.density.size(); ++k) {
    spectrum.density[k] /= static_cast<double>(spectrum.segments);
    spectrum.frequency.push_back(static_cast<double>(k) * spectrum.resolution);
  }
  const double degrees = degrees_of(spectrum.segments);
  constexpr double k_tail = 0.025;
  const boost::math::chi_squared distribution(degrees);
  spectrum.low = degrees / quantile(distribution, 1 - k_tail);
  spectrum.high = degrees / quantile(distribution, k_tail);
  return spectrum;
}

std::optional<Spectrum> spectrum_of(const std::vector<double>& series, double h) {
  constexpr std::size_t k_shortest = 16;
  // eight segments that overlap by half take 4.5 times the length of one
  std::size_t segment = k_shortest;
  if (9 * segment > 2 * series.size()) return std::nullopt;
  while (9 * (2 * segment) <= 2 * series.size()) segment *= 2;
  return spectrum_of(series, h, segment);
}

}  // namespace nilas::report
