#pragma once
/// Control from outside, in the list of modules.
#include "core/sim/build/module/module_sources.h"

namespace nilas::sim {

/// Must follow all modules that add commands, which it may set. Throws InputError for a perturbed run, and for a scene
/// that has nothing to command.
BuiltModule remote_control(const ModuleSources& from);

}  // namespace nilas::sim
