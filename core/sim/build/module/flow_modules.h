#pragma once
/// Currents, jets of propellers and the wind of a scene, and their modules.
#include "core/sim/build/module/module_sources.h"

namespace nilas::sim {

/// Adds the current and the jets of the scene to the water, before modules are built. Sets `current` and `jets` of the
/// parts. Throws InputError for a wrong table.
void add_flows(const scene::Scene& scene, hydro::Water& water, WorldParts& parts);

/// <wind>, and <wind_area> of the vessel.
BuiltModule wind(const ModuleSources& from);
/// <hydro><propeller_wash>. Throws InputError for a thruster that publishes no thrust; so it must come after them in
/// the list of modules.
BuiltModule propeller_wash(const ModuleSources& from);

}  // namespace nilas::sim
