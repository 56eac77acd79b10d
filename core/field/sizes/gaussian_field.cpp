#include "core/field/sizes/gaussian_field.h"

#include <cmath>

#include "core/base/error.h"

namespace nilas::field {

GaussianField::GaussianField(double length, RandomStream random) : length_(length) {
  NILAS_DEMAND(length > 0 && std::isfinite(length));
  // Multiples of the golden ratio spread most evenly over the circle.
  constexpr double k_golden = 0.6180339887498949;
  const double turn = random.uniform();
  for (int m = 0; m < k_modes; ++m) {
    const double u = (m + random.uniform()) / k_modes;
    const double k = std::sqrt(-4 * std::log1p(-u)) / length;
    const double along = turn + k_golden * m;
    const double angle = k_pi * (along - std::floor(along));  // k and -k are one wave
    modes_.push_back({k * Vec2(std::cos(angle), std::sin(angle)), 2 * k_pi * random.uniform()});
  }
}

double GaussianField::at(const Vec2& x) const {
  double sum = 0;
  for (const Mode& mode : modes_) sum += std::cos(mode.k.dot(x) + mode.phase);
  return std::sqrt(2.0 / k_modes) * sum;
}

double GaussianField::correlation(double distance, double length) {
  return std::exp(-(distance / length) * (distance / length));
}

}  // namespace nilas::field
