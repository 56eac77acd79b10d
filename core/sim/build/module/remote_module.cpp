#include "core/sim/build/module/remote_module.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/vessel/remote/remote_control.h"

namespace nilas::sim {

BuiltModule remote_control(const ModuleSources& from) {
  if (!from.scene.vessel || !from.scene.vessel->remote_control) return {};
  const scene::RemoteControlScene& remote = *from.scene.vessel->remote_control;
  const auto refuse = [&](const std::string& message) {
    throw InputError(from.scene.file.string() + ": <vessel><remote_control>: " + message);
  };
  if (from.scene.twin != 0)
    refuse("a perturbed run needs a controller and a socket of its own; allowed: no --twins, and <seed twin> 0");
  if (from.parts.commands->size() == 0 && !remote.force)
    refuse("the scene has nothing to command; allowed: a rudder, propeller or thruster, or force=\"true\"");
  return {vessel::make_remote_control({remote.socket, remote.timeout, remote.force}, from.parts.vessel_index,
                                      from.parts.bodies, from.scene.time.start, from.parts.commands),
          fmt::format("<vessel><remote_control>: at {}, waits up to {:g} s", remote.socket, remote.timeout)};
}

}  // namespace nilas::sim
