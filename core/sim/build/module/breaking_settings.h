#pragma once
/// Translates a scene's <fracture> into the settings of the fracture models.
#include <string>

#include "core/scene/scene.h"
#include "fracture/cut/cut_floe.h"
#include "fracture/model/breaking.h"

namespace nilas::sim {

/// All three functions throw ContractError when the scene has no <fracture>; the first also without <water> and <ice>.
fracture::BreakingSettings breaking_settings(const scene::Scene& scene);
fracture::PieceLimits piece_limits(const scene::Scene& scene);
/// One line for the list of what was built.
std::string breaking_description(const scene::Scene& scene);

}  // namespace nilas::sim
