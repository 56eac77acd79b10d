#pragma once
/// Outlines of the floes of a packed field.
#include "core/base/random.h"
#include "core/field/field.h"
#include "core/field/loose_floe.h"

namespace nilas {

/// Convex floe of the spec's shape, about the origin at angle zero, of `area` [m^2]. A polygon has vertices_min to
/// vertices_max corners on an ellipse, about evenly spread; a disc is a regular polygon of k_disc_corners corners.
LooseFloe draw_floe(const PackedSpec& spec, double area, RandomStream& random);

constexpr int k_disc_corners = 24;

}  // namespace nilas
