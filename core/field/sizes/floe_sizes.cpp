#include "core/field/sizes/floe_sizes.h"

#include <algorithm>
#include <boost/math/distributions/lognormal.hpp>
#include <cmath>
#include <functional>

#include "core/geometry/mass_properties.h"

namespace nilas::field {

namespace {

/// Quantile u of n(D) ~ D^-(1 + a) between low and high, by inversion of its cumulative distribution.
double power_law(double exponent, double low, double high, double u) {
  if (exponent == 0) return low * std::pow(high / low, u);
  const double at_low = std::pow(low, -exponent), at_high = std::pow(high, -exponent);
  return std::pow(at_low + u * (at_high - at_low), -1 / exponent);
}

double draw_size(const PackedSpec& spec, RandomStream& random) {
  switch (spec.distribution) {
    case SizeDistribution::fixed:
      return spec.mean;
    case SizeDistribution::uniform:
      return random.uniform(spec.min, spec.max);
    case SizeDistribution::power_law:
      return power_law(spec.exponent, spec.min, spec.max, random.uniform());
    case SizeDistribution::lognormal:
    case SizeDistribution::as_library:
      break;
  }
  return random.lognormal(spec.mean, spec.sd);
}

/// Quantile u of the library's sizes; its outlines are drawn with equal probability.
double library_quantile(const PackedSpec& spec, double u) {
  std::vector<double> sizes;
  for (const auto& outline : spec.library) sizes.push_back(std::sqrt(geometry::polygon_moments(outline).area));
  std::sort(sizes.begin(), sizes.end());
  const auto last = static_cast<double>(sizes.size()) - 1;
  return sizes[static_cast<std::size_t>(std::clamp(std::floor(u * (last + 1)), 0.0, last))];
}

}  // namespace

std::vector<double> draw_areas(const PackedSpec& spec, double wanted, RandomStream& random) {
  std::vector<double> areas;
  double sum = 0;
  while (true) {
    double size = draw_size(spec, random);
    if (spec.distribution != SizeDistribution::fixed) size = std::clamp(size, spec.min, spec.max);
    const double area = size * size;
    if (std::abs(sum + area - wanted) >= std::abs(sum - wanted)) break;  // without this floe the sum is nearer
    areas.push_back(area);
    sum += area;
  }
  std::sort(areas.begin(), areas.end(), std::greater<>());
  return areas;
}

double size_quantile(const PackedSpec& spec, double u) {
  switch (spec.distribution) {
    case SizeDistribution::fixed:
      return spec.mean;
    case SizeDistribution::uniform:
      return spec.min + u * (spec.max - spec.min);
    case SizeDistribution::power_law:
      return power_law(spec.exponent, spec.min, spec.max, u);
    case SizeDistribution::as_library:
      return library_quantile(spec, u);
    case SizeDistribution::lognormal:
      break;
  }
  if (spec.sd == 0) return std::clamp(spec.mean, spec.min, spec.max);
  if (u <= 0 || u >= 1) return u <= 0 ? spec.min : spec.max;
  const double variance = std::log1p(spec.sd * spec.sd / (spec.mean * spec.mean));
  const boost::math::lognormal sizes(std::log(spec.mean) - 0.5 * variance, std::sqrt(variance));
  return std::clamp(boost::math::quantile(sizes, u), spec.min, spec.max);
}

}  // namespace nilas::field
