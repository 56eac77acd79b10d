#pragma once
/// Checks of the specification of a field of random floes, and its bounds.
#include "core/field/spec/field_spec.h"
#include "core/field/spec/loose_floe.h"

namespace nilas::field {

/// Throws InputError naming the parameter, what was found and what is allowed.
void check_packed_spec(const PackedSpec& spec);

/// The region and the keep-out outlines grown by their margin. Throws InputError for an outline that is not convex.
FieldBounds field_bounds(const PackedSpec& spec);
/// Area of the region outside the obstacles [m^2].
double free_area(const FieldBounds& bounds);

}  // namespace nilas::field
