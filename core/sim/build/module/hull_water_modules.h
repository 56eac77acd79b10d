#pragma once
/// Water that moves with bodies, and the hydrostatics of a database.
#include "core/sim/build/module/module_sources.h"

namespace nilas::sim {

/// <hydro><restoring>. Throws InputError where the database has no hydrostatic stiffness.
BuiltModule restoring(const ModuleSources& from);
/// The watch over the tilt of a hull that takes loads of small angles from the database.
BuiltModule database_tilt(const ModuleSources& from);
/// <hydro><added_mass>. Throws InputError where the database has no added mass of infinite frequency.
BuiltModule added_mass(const ModuleSources& from);

}  // namespace nilas::sim
