#pragma once
/// Values of a valid scene that are probably not meant, as far as the file alone shows.
#include <vector>

#include "core/scene/document/document.h"

namespace nilas::scene {

/// Warnings with their places, on a resolved tree without faults.
std::vector<Fault> implausible_values(const SceneElement& root);

}  // namespace nilas::scene
