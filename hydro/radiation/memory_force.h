#pragma once
/// The radiation load of past motion, F(t) = -int_0^inf K(s) V(t - s) ds, in the two forms that a run can have.
#include <memory>
#include <vector>

#include "core/base/state.h"
#include "hydro/radiation/passive_fit.h"
#include "hydro/radiation/retardation.h"

namespace nilas::hydro {

/// The memory of one body. Velocities are linear between the times of advance(), whatever their spacing. Before the
/// first of them the motion was steady, which makes no load.
class MemoryForce {
 public:
  virtual ~MemoryForce() = default;
  /// The load at time t [s], at or after the last advance(), of a body that moves with V [m/s, rad/s] since then.
  /// Changes nothing.
  virtual Vec6 load(double t, const Vec6& V) const = 0;
  /// The body has the velocity V at time t, later than at the last call. The first call gives the start.
  virtual void advance(double t, const Vec6& V) = 0;
  virtual bool started() const = 0;
  virtual void save(StateWriter out) const = 0;
  virtual void restore(const StateReader& in) = 0;
};

/// The convolution, exact for velocities that are linear between the times. Integration by parts turns it into
///   F = - sum_i (V_(i+1) - V_i) [K2(s_i) - K2(s_(i+1))] / (s_i - s_(i+1)),   s_i = t - t_i,
/// with K2 of Retardation, cubic between its knots. Motion older than the memory counts as steady: since
/// int_0^inf K = B(0) = 0, the omitted part of the integral is then that of the oldest velocity, and steady motion
/// makes no load at all.
std::unique_ptr<MemoryForce> make_convolution(const Retardation& kernel);

/// The fitted models, as complex states x_k' = p_k x_k + V. A step is exact for a velocity that is linear over it:
///   x(t + h) = exp(p h) x + h (f1 - f2) V(t) + h f2 V(t + h),  f1 = (e^z - 1) / z,  f2 = (e^z - 1 - z) / z^2,  z = p
///   h.
/// The load is F = -sum 2 Re(R_k x_k). `scale`: that of RadiationDamping.
std::unique_ptr<MemoryForce> make_state_space(const std::vector<PassiveFit>& fits, const Vec6& scale);

}  // namespace nilas::hydro
