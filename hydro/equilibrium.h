#pragma once
/// Floating equilibrium: in heave at a given attitude, and in draught, trim and heel.
#include "core/geometry/mesh.h"
#include "core/geometry/shape.h"
#include "hydro/water.h"

namespace nilas {

/// z [m] of the mesh origin, at attitude R, where rho V = mass [kg] within 1e-12. Throws InputError when the body would
/// sink or the mass is not positive.
double floating_height(const TriangleMesh& mesh, const Mat3& R, double mass, const Water& water);

/// A body afloat at rest: buoyancy carries the weight and stands over the centre of mass.
struct FloatingEquilibrium {
  Pose pose;                   ///< of the centre of mass; x and y are 0
  double draught = 0;          ///< of the lowest point [m]
  double trim = 0;             ///< pitch: positive with the bow (+x) down [rad]
  double heel = 0;             ///< roll: positive with port (+y) up [rad]
  double volume = 0;           ///< displaced [m^3]
  double gm_transverse = 0;    ///< metacentre above the centre of mass, heeling about the horizontal along x [m]
  double gm_longitudinal = 0;  ///< trimming about the horizontal across it [m]
  double gm_least = 0;         ///< about whichever horizontal axis is the softest; negative: unstable [m]
  bool stable() const { return gm_least > 0; }
};

/// The equilibrium that Newton's method with line search (KINSOL) reaches from the attitude `start`, at its heading:
/// rho V = mass, and the centre of buoyancy over the centre of mass, within 1e-10 of the mass and of the body's radius.
/// `shape` about the centre of mass, as in the body arrays; its water integrals are those of the buoyancy module. An
/// equilibrium need not be stable: an upright start stays upright. Throws InputError when the body would sink, has no
/// positive mass or bounded shape, or when no equilibrium is found.
FloatingEquilibrium floating_equilibrium(const Shape& shape, double mass, const Quat& start, const Water& water);

}  // namespace nilas
