#pragma once
/// The waves of a scene, and the modules of their loads and of those of the waves that the vessel makes.
#include "core/sim/build/module/module_sources.h"

namespace nilas::sim {

/// Draws the waves of the scene, lists them, and adds their motion to that of the water. Sets `waves` of the parts; it
/// stays empty without <waves>. `water` has density, level and gravity. Throws InputError that names file and line.
void add_waves(const scene::Scene& scene, hydro::Water& water, WorldParts& parts);

/// <hydro><radiation>.
BuiltModule radiation(const ModuleSources& from);

/// <hydro><wave_loads>.
BuiltModule wave_loads(const ModuleSources& from);

}  // namespace nilas::sim
