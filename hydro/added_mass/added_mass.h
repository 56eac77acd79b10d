#pragma once
/// Added mass of floes and of the vessel.
#include <memory>
#include <optional>

#include "core/bodies/module.h"
#include "core/choices/water_choices.h"

namespace nilas::hydro {

/// Moves a 6 x 6 matrix of velocities before rotations from one reference point to another: `arm` leads from the new
/// point to the old one, in the axes of the matrix [m].
Mat6 about_other_point(const Mat6& matrix, const Vec3& arm);

/// The module of added mass. Floes have that of floe_added_mass(), with the draught of their weight; other free bodies
/// have none. `vessel`: that of the hull about its centre of mass in body axes; empty: none. `density` [kg/m^3].
std::unique_ptr<bodies::Module> make_added_mass(FloeAddedMass floes, double density, std::optional<Mat6> vessel);

}  // namespace nilas::hydro
