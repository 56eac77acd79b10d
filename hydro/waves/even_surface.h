#pragma once
/// A surface of a prism whose triangles do not depend on the axes of its frame.
#include "core/geometry/mesh.h"
#include "core/geometry/shape.h"

namespace nilas::hydro {

/// The closed outward surface of a prism, in its own frame. Each side has four triangles about its middle. Each cap of
/// a convex prism has one triangle an edge about the centroid, so that a turned or mirrored outline has turned or
/// mirrored triangles. Caps of a concave prism have the triangles of `prism.surface`, whose diagonals may differ.
/// Throws ContractError for another shape.
geometry::TriangleMesh even_surface(const geometry::Shape& prism);

}  // namespace nilas::hydro
