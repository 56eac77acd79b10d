#pragma once
/// Bending of an ice sheet at its free edge under a line load, which starts radial cracks.
#include "fracture/split/tabulate.h"

namespace nilas::fracture {

/// A semi-infinite elastic plate on water with a free edge, on which a load P is spread evenly over the length 2 b. The
/// theory is that of thin plates, so that b must not be much below h. The constructor tabulates the Fourier solution of
/// fracture/bend/edge_integral.h for one Poisson's ratio. The functions are then cheap and continuously differentiable.
class EdgeLoad {
 public:
  /// Takes Poisson's ratio. Throws ContractError unless 0 <= nu <= 0.5.
  explicit EdgeLoad(double nu);

  /// The factor sigma h^2 / P, where sigma = 6 M_y / h^2 is the largest bending stress along the edge. It is within
  /// 1e-6 of the integral for 1e-3 <= b/l <= 10. Below, it is the logarithmic limit. Above, it is the limit of two ends
  /// that do not affect each other, 3 S(u*) / b. Both limits are as accurate. Up to widest_centred() the largest stress
  /// is at the middle of the load, beyond near its ends. Throws ContractError unless b_over_l > 0.
  double stress_factor(double b_over_l) const;
  /// The largest b/l for which the stress is largest at the middle of the load.
  double widest_centred() const { return widest_centred_; }
  /// The deflection w k l^2 / P of the edge under a point load.
  double deflection() const { return deflection_; }

 private:
  double log_slope_, deflection_, widest_centred_;
  double near_factor_, far_factor_;  ///< Stress factors at the least and the largest b/l of the tables.
  TableSpline centred_, split_;      ///< Functions of ln(b/l) below and above widest_centred_.
};

/// The load P [N], spread over 2 b of the edge, at which the stress reaches flexural_strength [Pa]. l is the plate's
/// characteristic length. All lengths are in [m]. Throws ContractError unless all arguments are positive.
double radial_crack_load(const EdgeLoad& edge, double b, double l, double thickness, double flexural_strength);

}  // namespace nilas::fracture
