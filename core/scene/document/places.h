#pragma once
/// Places of a scene's elements and attributes, for faults that only appear when the scene is built.
#include <map>
#include <string>

#include "core/scene/document/document.h"

namespace nilas::scene {

/// The places in the form of Scene::places.
std::map<std::string, Fault> places_of(const SceneElement& root);

}  // namespace nilas::scene
