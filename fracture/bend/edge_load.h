#pragma once
/// Bending of an ice sheet at its free edge under a line load: when radial cracks start.
#include "fracture/split/tabulate.h"

namespace nilas {

/// Semi-infinite elastic plate on water, free edge, load P spread evenly over the length 2 b of the edge; thin-plate
/// theory, so for b not much below h. Built once per Poisson's ratio (a table of the Fourier solution,
/// fracture/bend/edge_integral.h), cheap and continuously differentiable after that.
class EdgeLoad {
 public:
  /// 0 <= nu <= 0.5, else ContractError.
  explicit EdgeLoad(double nu);

  /// sigma h^2 / P, sigma = 6 M_y / h^2 the largest bending stress along the edge; b_over_l > 0, else ContractError.
  /// Within 1e-6 of the integral for 1e-3 <= b/l <= 10; below, its logarithmic limit, above, the limit of two ends that
  /// do not feel each other (3 S(u*) / b), as exact. Up to `widest_centred` the largest stress is at the middle of the
  /// load, beyond that near its ends.
  double stress_factor(double b_over_l) const;
  double widest_centred() const { return widest_centred_; }
  /// w k l^2 / P at the edge under a point load.
  double deflection() const { return deflection_; }

 private:
  double log_slope_, deflection_, widest_centred_;
  double near_factor_, far_factor_;  ///< stress factors at the least and the largest b/l of the tables
  TableSpline centred_, split_;      ///< of ln(b/l), below and above widest_centred_
};

/// Load P [N] spread over 2 b of the edge at which the stress reaches flexural_strength [Pa]; l is the plate's
/// characteristic length. Lengths [m].
double radial_crack_load(const EdgeLoad& edge, double b, double l, double thickness, double flexural_strength);

}  // namespace nilas
