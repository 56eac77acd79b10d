#pragma once
/// Forces on a hull as sums of given derivatives.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/choices/manoeuvring_choices.h"
#include "hydro/manoeuvring/planar_motion.h"

namespace nilas::hydro {

/// One term: a coefficient times powers of surge, sway, yaw rate and rudder angle.
struct DerivativeTerm {
  enum class Load { X, Y, N };
  Load load = Load::X;
  std::array<int, 4> powers{};           ///< of u - reference speed, v, r, rudder angle
  std::array<int, 4> absolute_powers{};  ///< of their absolute values
  double value = 0;
};

/// A hull by its derivatives [Abkowitz 1964; Norrbin 1971 for the bis system; Fossen 2011]. Terms have the names of the
/// literature: `Y_v`, `N_vvr`, `X_u|u|`, `Y_d` (rudder angle) and `X_0` (a constant); `X_udot`, `Y_vdot`, `Y_rdot`,
/// `N_vdot` and `N_rdot` are those of the accelerations. With a reference speed, u in the terms is the surge velocity
/// less that speed. The units of velocity are U and U/L in the prime systems and sqrt(g L) and sqrt(g/L) in the bis
/// system, whose unit of force is m g.
struct DerivativesHull {
  DerivativeScaling scaling = DerivativeScaling::si;
  double length = 0;           ///< L [m]
  double draught = 0;          ///< d, for prime-draught [m]
  double mass = 0;             ///< m, for bis [kg]
  double gravity = 0;          ///< g, for bis [m/s^2]
  double reference_speed = 0;  ///< [m/s]
  double X_udot = 0, Y_vdot = 0, Y_rdot = 0, N_vdot = 0, N_rdot = 0;
  std::vector<DerivativeTerm> terms;
};

/// The term with this name, without a value; nothing where it is no name of a term.
std::optional<DerivativeTerm> derivative_term(const std::string& name);

/// The sums. `rudder`: its angle [rad]. In the prime systems the speed that makes velocities dimensionless is not below
/// abs(r) L / k_mmg_yaw_rate, and the deviation from a reference speed is not below -1, its value at half of that speed
/// on a straight course. So all loads fall to zero at rest with the square of the speed.
PlanarLoads derivatives_loads(const DerivativesHull& hull, double density, const PlanarMotion& motion, double rudder);

/// The added masses -X_udot, -Y_vdot, -(Y_rdot + N_vdot)/2 and -N_rdot with dimension. The mass of a rigid body and of
/// the water around it is symmetric, so two different couplings are replaced by their mean.
PlanarAddedMass derivatives_added_mass(const DerivativesHull& hull, double density);

}  // namespace nilas::hydro
