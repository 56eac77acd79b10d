#pragma once
/// A faceted sphere for the drag law, which acts face by face.
#include "core/geometry/mesh.h"

namespace nilas::hydro {

/// An octahedron with each edge cut in eight and its vertices moved onto a sphere about the origin. It has 512 outward
/// triangles with the area of the sphere of this radius [m]. It is exactly mirror-symmetric in x, y and z. Octants do
/// not share vertices.
geometry::TriangleMesh sphere_surface(double radius);

}  // namespace nilas::hydro
