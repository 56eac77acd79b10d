#pragma once
/// Floating equilibrium in heave at a given attitude.
#include "core/bodies/mesh.h"
#include "hydro/water.h"

namespace nilas {

/// z [m] of the mesh origin, at attitude R, where rho V = mass [kg] within 1e-12. Throws InputError when the body would
/// sink or the mass is not positive.
double floating_height(const TriangleMesh& mesh, const Mat3& R, double mass, const Water& water);

}  // namespace nilas
