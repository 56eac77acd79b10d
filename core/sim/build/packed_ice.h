#pragma once
/// What a scene asks of fields of random floes, in the terms of the generators.
#include "core/field/spec/field_spec.h"
#include "core/scene/elements/field_scene.h"

namespace nilas {

/// Concentration, sizes and outlines; the region, the outlines to keep clear of and the seed are left to the caller.
/// Throws FileError and InputError for a library of outlines that cannot be read.
PackedSpec packed_spec(const PackedFieldScene& field);
PackedSpec cell_spec(const VoronoiFieldScene& field);

}  // namespace nilas
