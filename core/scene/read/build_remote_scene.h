#pragma once
/// Converts <remote_control> to its plain values.
#include "core/scene/document/document.h"
#include "core/scene/elements/remote_scene.h"

namespace nilas::scene {

RemoteControlScene build_remote_control_scene(const SceneElement& element);

}  // namespace nilas::scene
