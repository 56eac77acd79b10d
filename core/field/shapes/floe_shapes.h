#pragma once
/// Outlines of the floes of a packed field.
#include "core/base/random.h"
#include "core/field/spec/field_spec.h"
#include "core/field/spec/loose_floe.h"

namespace nilas::field {

/// A floe of the spec's shape about the origin at angle zero, of `area` [m^2]. A polygon has vertices_min to
/// vertices_max corners on an ellipse, with nearly even spacing. A disc is a regular polygon of k_disc_corners corners.
/// An outline of the library may be concave; `area` is then that of the ice.
LooseFloe draw_floe(const PackedSpec& spec, double area, RandomStream& random);

/// Outlines drawn from the spec's library at their own sizes, about the origin, largest first: areas sum to `wanted`
/// [m^2] to within half a floe.
std::vector<LooseFloe> draw_library_floes(const PackedSpec& spec, double wanted, RandomStream& random);

constexpr int k_disc_corners = 24;

}  // namespace nilas::field
