#pragma once
/// --set PATH=VALUE, applied to the tree of a scene before it is checked.
#include <vector>

#include "core/scene/document/document.h"
#include "core/scene/read/read_scene.h"

namespace nilas {

/// Sets each attribute; a missing optional element on the way is made. `element[+]` of elements that there may be many
/// of is one more at their end: all such paths mean the same one. A path that leads nowhere becomes a fault.
void apply_overrides(SceneElement& root, const Overrides& overrides, std::vector<Fault>& faults);

}  // namespace nilas
