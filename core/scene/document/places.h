#pragma once
/// Places of a scene's elements and attributes, for what shows only when the scene is built.
#include <map>
#include <string>

#include "core/scene/document/document.h"

namespace nilas {

/// As of Scene::places.
std::map<std::string, Fault> places_of(const SceneElement& root);

}  // namespace nilas
