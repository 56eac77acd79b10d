#pragma once
/// Entries of the module list for the vessel's thrusters and their control.
#include "core/sim/build/module/module_sources.h"
#include "core/vessel/thrusters/thruster.h"

namespace nilas::sim {

/// The thruster of an element. Throws InputError and FileError for a wrong table of thrust loss.
vessel::Thruster thruster_of(const scene::ThrusterScene& given, const ModuleSources& from);

/// <thrusters>, as vessel::make_thrusters(). Throws InputError and FileError for a wrong table of thrust loss.
BuiltModule build_thrusters(const ModuleSources& from);
/// <control mode="dp">, as vessel::make_dp(). It comes after the thrusters, and after the wind that it cancels. Throws
/// InputError and FileError for a wrong path, and for an observer that does not converge.
BuiltModule build_control(const ModuleSources& from);

}  // namespace nilas::sim
