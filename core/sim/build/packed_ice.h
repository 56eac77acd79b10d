#pragma once
/// Translates a scene's fields of random floes into the settings of the generators.
#include "core/field/spec/field_spec.h"
#include "core/scene/elements/field_scene.h"

namespace nilas::sim {

/// Concentration, sizes and outlines. The caller fills in the region, the outlines to keep clear of and the seed.
/// Sizes are in the unit of length [m]; those of a library are in metres, as stored. Throws FileError and InputError
/// for a library of outlines that cannot be read.
field::PackedSpec packed_spec(const scene::PackedFieldScene& field, double unit);
field::PackedSpec cell_spec(const scene::VoronoiFieldScene& field, double unit);
/// The spec with all lengths multiplied by `factor`.
field::PackedSpec scaled(field::PackedSpec spec, double factor);

}  // namespace nilas::sim
