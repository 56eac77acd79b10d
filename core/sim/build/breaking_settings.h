#pragma once
/// What a scene asks of breaking, in the terms of the models.
#include <string>

#include "core/scene/scene.h"
#include "fracture/cut/cut_floe.h"
#include "fracture/model/breaking.h"

namespace nilas {

/// All three throw ContractError when the scene names no <fracture>, the first also without <water> and <ice>.
BreakingSettings breaking_settings(const Scene& scene);
PieceLimits piece_limits(const Scene& scene);
/// For the list of what was built.
std::string breaking_description(const Scene& scene);

}  // namespace nilas
