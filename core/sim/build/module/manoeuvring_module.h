#pragma once
/// Builds the modules of a scene's <manoeuvring> and <manoeuvre>.
#include "core/sim/build/module/module_sources.h"

namespace nilas::sim {

/// Both return nothing where the scene has no such element. They throw InputError where the ship's file is faulty or
/// the propeller cannot hold the wanted speed.
BuiltModule build_manoeuvring(const ModuleSources& from);
BuiltModule build_manoeuvre(const ModuleSources& from);

}  // namespace nilas::sim
