#pragma once
/// Shape and mass of a <body> or <part> element.
#include <memory>
#include <string>

#include "core/geometry/mass_properties.h"
#include "core/geometry/shape.h"
#include "core/scene/scene.h"

namespace nilas {

struct Solid {
  std::shared_ptr<const Shape> shape;  ///< about the centre of mass, along the element's axes
  MassProperties mass;                 ///< com in the element's frame
};

/// Throws InputError and FileError naming the mesh file that is at fault.
Solid build_solid(const SolidScene& scene);

/// About z, then the new y, then the new x.
Quat attitude_of(const Vec3& yaw_pitch_roll_deg);

}  // namespace nilas
