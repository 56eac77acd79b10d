#pragma once
/// The force module of a moored vessel.
#include <memory>

#include "core/base/log.h"
#include "core/bodies/module.h"
#include "core/vessel/mooring/mooring_model.h"

namespace nilas::vessel {

/// The state of a mooring at the start: no line is broken, and the turret is at rest at its lines' balance.
MooringState initial_mooring(const MooringModel& model, const Pose& hull);

/// Makes the module `mooring`, which holds body `hull`. Its lines are at rest at each instant: their inertia and drag
/// are left out. The loads depend on pose and velocity of the hull and on the state alone. A line breaks at the end of
/// the substep in which its tension reaches its break load, or its time has come; the log tells of each. The turret
/// follows the poses within a substep; what it has turned is kept at the end. Columns of steps.csv:
/// line_<name>_tension_N, mooring_broken_1 and, with a turret, turret_angle_rad. `bodies` are those of the start, and
/// `warnings` must outlive the module. add_forces() throws SimulationError where a fairlead sinks into the sea bed or a
/// turret finds no balance.
std::unique_ptr<bodies::ForceModule> make_mooring(const MooringModel& model, int hull, const bodies::Bodies& bodies,
                                                  WarningCounts& warnings);

}  // namespace nilas::vessel
