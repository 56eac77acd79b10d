#pragma once
/// Which bodies take water forces, and their geometry prepared for them.
#include <memory>
#include <variant>
#include <vector>

#include "core/bodies/bodies.h"
#include "hydro/mesh_water.h"
#include "hydro/wetted.h"

namespace nilas {

/// Water acts on free floes and rigid bodies with a bounded shape, and on the vessel however it moves.
bool takes_water(const Bodies& bodies, int b);

/// Prepared geometry of one body; empty for a plane, and for a sphere where its closed form serves.
using WetGeometry = std::variant<std::monostate, PrismWater, MeshWater>;

/// What a module keeps per body. `Result` is the module's own slot, reset when the body in it changes.
template <class Result>
struct WetBody {
  std::shared_ptr<const Shape> shape;
  WetGeometry geometry;
  Result result{};
};

/// Brings the list in step with the bodies (which come, go, change shape and are freed when ice breaks); prepares what
/// is new in the water with prepare(shape).
template <class Result, class Prepare>
void follow(const Bodies& bodies, std::vector<WetBody<Result>>& list, const Prepare& prepare) {
  list.resize(bodies.shape.size());
  for (std::size_t b = 0; b < list.size(); ++b)
    if (list[b].shape != bodies.shape[b] && takes_water(bodies, static_cast<int>(b)))
      list[b] = {bodies.shape[b], prepare(*bodies.shape[b]), Result{}};
}

/// Prism by its outline; box, cylinder and mesh by their surface.
WetGeometry prepare_geometry(const Shape& shape);

}  // namespace nilas
