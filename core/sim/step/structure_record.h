#pragma once
/// Loads on the bodies that a scene holds fixed.
#include <vector>

#include "contact/step_motion.h"
#include "core/sim/account/step_record.h"
#include "core/sim/world/world_state.h"

namespace nilas::sim {

/// Adds the loads of a substep, weighted with its share of the step, to the means.
void add_structure_loads(const World& world, const contact::StepMotion& motion, std::vector<StructureRecord>& records);

}  // namespace nilas::sim
