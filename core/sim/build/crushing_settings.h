#pragma once
/// What a scene asks of crushing, in the terms of the model.
#include <string>

#include "core/bodies/bodies.h"
#include "core/scene/scene.h"
#include "fracture/model/crushing.h"

namespace nilas {

/// Both throw ContractError when the scene names no <crushing>.
CrushingSettings crushing_settings(const Scene& scene);
/// For the list of what was built; names the bodies that stay rigid.
std::string crushing_description(const Scene& scene, const Bodies& bodies);

}  // namespace nilas
