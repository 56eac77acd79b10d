#pragma once
/// Translates a scene's <crushing> into the settings of the crushing model.
#include <string>

#include "core/bodies/bodies.h"
#include "core/scene/scene.h"
#include "fracture/model/crushing.h"

namespace nilas {

/// Both functions throw ContractError when the scene has no <crushing>.
CrushingSettings crushing_settings(const Scene& scene);
/// One line for the list of what was built. It names the bodies that stay rigid.
std::string crushing_description(const Scene& scene, const Bodies& bodies);

}  // namespace nilas
