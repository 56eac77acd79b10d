#pragma once
/// Translates a scene's <crushing> into the settings of the crushing model.
#include <string>

#include "core/bodies/bodies.h"
#include "core/scene/scene.h"
#include "fracture/model/crushing.h"

namespace nilas::sim {

/// Both functions throw ContractError when the scene has no <crushing>.
fracture::CrushingSettings crushing_settings(const scene::Scene& scene);
/// One line for the list of what was built. It names the bodies that stay rigid.
std::string crushing_description(const scene::Scene& scene, const bodies::Bodies& bodies);

}  // namespace nilas::sim
