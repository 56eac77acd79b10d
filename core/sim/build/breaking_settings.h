#pragma once
/// Translates a scene's <fracture> into the settings of the fracture models.
#include <string>

#include "core/scene/scene.h"
#include "fracture/cut/cut_floe.h"
#include "fracture/model/breaking.h"

namespace nilas {

/// All three functions throw ContractError when the scene has no <fracture>; the first also without <water> and <ice>.
BreakingSettings breaking_settings(const Scene& scene);
PieceLimits piece_limits(const Scene& scene);
/// One line for the list of what was built.
std::string breaking_description(const Scene& scene);

}  // namespace nilas
