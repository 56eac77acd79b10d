#include "core/scene/read/build_remote_scene.h"

#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

RemoteControlScene build_remote_control_scene(const SceneElement& element) {
  RemoteControlScene remote;
  assign(remote.socket, element, "socket");
  assign(remote.timeout, element, "timeout");
  assign(remote.force, element, "force");
  return remote;
}

}  // namespace nilas::scene
