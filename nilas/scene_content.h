#pragma once
/// What a Scene holds.
#include "core/scene/scene.h"
#include "nilas/scene.h"

namespace nilas {

struct Scene::Content {
  scene::Scene scene;
};

}  // namespace nilas
