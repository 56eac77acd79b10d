#pragma once
/// The fit of a passive rational model to radiation damping.
#include <optional>
#include <vector>

#include "hydro/radiation/damping.h"
#include "hydro/radiation/rational.h"
#include "hydro/radiation/retardation.h"

namespace nilas::hydro {

/// K(i w) = B(w) + i w (A(w) - A_inf), the transform of the scaled retardation function, at the frequencies of fits.
struct RadiationSamples {
  std::vector<double> frequency;  ///< rising, > 0 [rad/s]
  VecX weight;                    ///< root of the width of each frequency
  Eigen::MatrixXcd value;         ///< one row of 36 entries per frequency
  double peak = 0;                ///< where the damping is largest [rad/s]
};
/// Its real part is the damping, its imaginary part the sine transform of the retardation function.
RadiationSamples radiation_samples(const RadiationDamping& damping, const Retardation& kernel);

/// A passive model of one group of coupled modes, and how well it fits.
struct PassiveFit {
  RationalModel model;  ///< of the scaled damping
  /// Root-mean-square error of the damping over all frequencies, as a share of the damping. By Parseval's theorem it
  /// is also that of the retardation function over all times.
  double error = 0;
};

/// Fits the model with `order` poles:
/// 1. Vector fitting of the samples gives poles.
/// 2. Every passive model with these poles has a spectral factor W(s) = sum W_k / (s - p_k), such that
///    H(s) + H(-s)^T = W(-s)^T W(s). Its damping is 0.5 |W(i w)|^2 and cannot be negative at any frequency. The W_k are
///    found by nonlinear least squares on B(w) [Levenberg 1944; Marquardt 1963]. So the unconstrained fit is perturbed
///    until it is passive, and no more than the data ask for.
/// 3. W(0) = 0, so that H(0) = 0: steady motion makes no load. Residues of H follow by partial fractions, and their
///    symmetric parts are taken, which keeps H passive.
PassiveFit passive_fit(const RadiationSamples& samples, const std::vector<int>& modes, int order);

/// The largest number of poles of a group of modes.
constexpr int k_most_poles = 24;

/// The model of least order, up to k_most_poles, whose error is below `error`; or the one of the given order. Throws
/// InputError where no such order has so small an error.
PassiveFit chosen_fit(const RadiationSamples& samples, const std::vector<int>& modes, double error,
                      std::optional<int> order = std::nullopt);

}  // namespace nilas::hydro
