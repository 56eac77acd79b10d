#pragma once
/// A stationary, isotropic Gaussian random field over the plane, by random Fourier modes.
#include <vector>

#include "core/base/math.h"
#include "core/base/random.h"

namespace nilas::field {

/// Zero mean, unit variance, correlation exp(-(d/length)^2) at distance d: 1/e at the correlation length. The sum
///   g(x) = sqrt(2/N) sum_m cos(k_m . x + phi_m)
/// has wave vectors k_m drawn from the spectrum of that covariance (normal, variance 2/length^2 per component),
/// stratified in length and direction, and uniform phases phi_m [Shinozuka and Deodatis 1991; the spectral method].
/// Smooth, and defined everywhere: no grid. By the phases the covariance is that of the wave vectors at hand, within
/// about 0.01 of the one stated; one point over many seeds is normal but for an excess kurtosis of -1.5/N.
class GaussianField {
 public:
  /// length [m] > 0.
  GaussianField(double length, RandomStream random);
  double at(const Vec2& x) const;
  double length() const { return length_; }
  /// The stated correlation.
  static double correlation(double distance, double length);

  static constexpr int k_modes = 256;

 private:
  struct Mode {
    Vec2 k;  ///< [1/m]
    double phase;
  };
  double length_;
  std::vector<Mode> modes_;
};

}  // namespace nilas::field
