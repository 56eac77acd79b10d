#pragma once
/// Floating equilibrium: in heave at a given attitude, or in draught, trim and heel.
#include "core/geometry/mesh.h"
#include "core/geometry/shape.h"
#include "hydro/water.h"

namespace nilas::hydro {

/// The height z [m] of the mesh origin at which a body of attitude R floats: rho V = mass [kg] within 1e-12 of the
/// mass. Throws InputError when the body would sink, when the mass is not positive, or for a mesh without triangles.
double floating_height(const geometry::TriangleMesh& mesh, const Mat3& R, double mass, const Water& water);

/// A body afloat at rest: buoyancy carries the weight, and its centre is on the vertical through the centre of mass.
struct FloatingEquilibrium {
  Pose pose;                   ///< The pose of the centre of mass; x and y are 0.
  double draught = 0;          ///< The draught of the lowest point [m].
  double trim = 0;             ///< The pitch, positive with the bow (+x) down [rad].
  double heel = 0;             ///< The roll, positive with port (+y) up [rad].
  double volume = 0;           ///< The displaced volume [m^3].
  double gm_transverse = 0;    ///< GM for heel about the horizontal axis along x [m].
  double gm_longitudinal = 0;  ///< GM for trim about the horizontal axis across x [m].
  double gm_least = 0;         ///< GM about the softest horizontal axis [m]; negative: unstable.
  bool stable() const { return gm_least > 0; }
};

/// The equilibrium that Newton's method with line search (KINSOL) reaches from the attitude `start`, with its heading.
/// There rho V = mass within 1e-10 of the mass, and the centre of buoyancy is on the vertical through the centre of
/// mass within 1e-10 of the body's radius. `shape` is about the centre of mass, as in the body arrays. Its water
/// integrals are those of the buoyancy module. The equilibrium need not be stable: an upright start stays upright.
/// Throws InputError when the body would sink, has no positive mass or no bounded shape, or when no equilibrium is
/// found.
FloatingEquilibrium floating_equilibrium(const geometry::Shape& shape, double mass, const Quat& start,
                                         const Water& water);

}  // namespace nilas::hydro
