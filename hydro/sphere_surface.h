#pragma once
/// Faceted sphere for the face-wise drag law.
#include "core/geometry/mesh.h"

namespace nilas {

/// Octahedron with each edge cut in eight and raised to a sphere about the origin: 512 outward triangles with the area
/// of the sphere of this radius [m], exactly mirror-symmetric in x, y and z. Octants do not share vertices.
TriangleMesh sphere_surface(double radius);

}  // namespace nilas
