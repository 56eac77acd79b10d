#pragma once
/// The bodies that water acts on, and their geometry prepared for its forces.
#include <memory>
#include <variant>
#include <vector>

#include "core/bodies/bodies.h"
#include "hydro/mesh_water.h"
#include "hydro/wetted.h"

namespace nilas::hydro {

/// Whether water acts on body b: on free floes and rigid bodies with a bounded shape, and on the vessel in any mode.
bool takes_water(const bodies::Bodies& bodies, int b);

/// The prepared geometry of one body. It is empty for a plane, and for a sphere whose closed form is used.
using WetGeometry = std::variant<std::monostate, PrismWater, MeshWater>;

/// The data that a module keeps per body. `Result` is the module's own data, reset when another body takes the place.
template <class Result>
struct WetBody {
  std::shared_ptr<const geometry::Shape> shape;
  WetGeometry geometry;
  Result result{};
};

/// Updates the list after bodies came, went, changed shape or were freed, as they do when ice breaks. Calls
/// prepare(shape) for each body that is new in the water.
template <class Result, class Prepare>
void follow(const bodies::Bodies& bodies, std::vector<WetBody<Result>>& list, const Prepare& prepare) {
  list.resize(bodies.shape.size());
  for (std::size_t b = 0; b < list.size(); ++b)
    if (list[b].shape != bodies.shape[b] && takes_water(bodies, static_cast<int>(b)))
      list[b] = {bodies.shape[b], prepare(*bodies.shape[b]), Result{}};
}

/// The surface of a shape on which water acts [m, in B]. The faces of a box or cylinder are triangles around their
/// middles: with one diagonal per face, loads on a body that spins or lies in waves would have a side.
geometry::TriangleMesh water_surface(const geometry::Shape& shape);
/// Prepares a prism from its outline, and a box, cylinder or mesh from its surface. Empty for other shapes.
WetGeometry prepare_geometry(const geometry::Shape& shape);

}  // namespace nilas::hydro
