#pragma once
/// --set PATH=VALUE, applied to the tree of a scene before it is checked.
#include <vector>

#include "core/scene/document/document.h"
#include "core/scene/read/read_scene.h"

namespace nilas::scene {

/// Sets each attribute. Missing optional elements on the path are created. `element[+]` adds one more element at the
/// end, where several are allowed; all such paths mean the same one. A path that leads nowhere becomes a fault.
void apply_overrides(SceneElement& root, const Overrides& overrides, std::vector<Fault>& faults);

}  // namespace nilas::scene
