#pragma once
/// What a scene asks of crushing, in the terms of the model.
#include <string>

#include "core/bodies/bodies.h"
#include "core/scene/scene.h"
#include "fracture/crushing_law.h"

namespace nilas {

/// Both throw ContractError when the scene names no <crushing>.
CrushingLaw crushing_law(const Scene& scene);
/// For the list of what was built; names the bodies that stay rigid.
std::string crushing_description(const Scene& scene, const Bodies& bodies);

}  // namespace nilas
