#pragma once
/// Shape and mass of a <body> or <part> element.
#include <memory>
#include <string>

#include "core/geometry/mass_properties.h"
#include "core/geometry/shape.h"
#include "core/scene/scene.h"

namespace nilas::sim {

struct Solid {
  std::shared_ptr<const geometry::Shape> shape;  ///< origin at the centre of mass, axes of the element
  geometry::MassProperties mass;                 ///< centre of mass in the element's frame
};

/// Builds shape and mass. `file_scale` multiplies the lengths of a mesh file. Throws InputError and FileError naming
/// the mesh file that is at fault.
Solid build_solid(const scene::SolidScene& scene, double file_scale);

/// The attitude after turns about z, then about the new y, then about the new x [deg].
Quat attitude_of(const Vec3& yaw_pitch_roll_deg);

}  // namespace nilas::sim
