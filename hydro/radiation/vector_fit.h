#pragma once
/// Poles of a measured transfer function by vector fitting.
#include <vector>

#include "hydro/radiation/rational.h"

namespace nilas::hydro {

/// Samples of a symmetric transfer function on the imaginary axis.
struct FrequencySamples {
  std::vector<double> frequency;  ///< rising, > 0 [rad/s]
  std::vector<MatXc> value;       ///< H(i w), square and symmetric
  VecX weight;                    ///< root of the weight of each frequency in the sum of squares
};

/// The `count` common poles of all entries, by relaxed vector fitting [Gustavsen & Semlyen 1999; Gustavsen 2006]: with
/// the poles a_k of the last iteration, the linear least-squares problem
///   sum c_k / (s - a_k) = H(s) (d + sum c'_k / (s - a_k)),  mean of Re(d + sum ...) = 1,
/// gives the next poles as the zeros of the bracket. Poles in the right half plane are mirrored, so all are stable.
/// `peak`: frequency around which the first poles lie [rad/s].
Poles fit_poles(const FrequencySamples& samples, int count, double peak);

}  // namespace nilas::hydro
