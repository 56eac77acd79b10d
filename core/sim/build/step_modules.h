#pragma once
/// What a step does beside the loads: contact, crushing, breaking, for the list of what was built and why.
#include "core/scene/scene.h"
#include "core/sim/world/world.h"

namespace nilas {

bool has_crushing(const Scene& scene, const WorldParts& parts);
bool has_breaking(const Scene& scene, const WorldParts& parts);
bool clears_crushed_ice(const Scene& scene, const WorldParts& parts);
/// Appends them to parts.info.modules.
void list_step_modules(const Scene& scene, WorldParts& parts);

}  // namespace nilas
