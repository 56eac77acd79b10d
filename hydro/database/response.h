#pragma once
/// Motions of a floating body in regular waves, in the frequency domain.
#include <vector>

#include "hydro/database/database.h"

namespace nilas::hydro {

/// The mass matrix of a rigid body about the origin of D. `mass` [kg]; `centre_of_gravity` in frame D [m]; `radii` of
/// gyration about the axes of D through its origin, not through the centre of gravity, as WAMIT's FORCE file has them
/// [m]. Products of inertia are zero.
Mat6 rigid_mass(double mass, const Vec3& centre_of_gravity, const Vec3& radii);

/// The response to a wave of unit amplitude [m/m, rad/m]: x = [-w^2 (M + A) + i w B + C]^-1 X [Newman 1977, 6.18].
/// `restoring` holds the weight's part too. `frequency` [rad/s].
ComplexVec6 response(double frequency, const Mat6& mass, const Mat6& added_mass, const Mat6& damping,
                     const Mat6& restoring, const ComplexVec6& excitation);

/// The same for all frequencies and headings of a database, [frequency][heading], about the origin of D. Throws
/// InputError where the database has no excitation or no hydrostatic stiffness.
std::vector<std::vector<ComplexVec6>> responses(const Database& database, const Mat6& mass);

}  // namespace nilas::hydro
