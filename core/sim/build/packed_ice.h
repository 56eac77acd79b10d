#pragma once
/// Translates a scene's fields of random floes into the settings of the generators.
#include "core/field/spec/field_spec.h"
#include "core/scene/elements/field_scene.h"

namespace nilas::sim {

/// Concentration, sizes and outlines. The caller fills in the region, the outlines to keep clear of and the seed.
/// Throws FileError and InputError for a library of outlines that cannot be read.
field::PackedSpec packed_spec(const scene::PackedFieldScene& field);
field::PackedSpec cell_spec(const scene::VoronoiFieldScene& field);

}  // namespace nilas::sim
