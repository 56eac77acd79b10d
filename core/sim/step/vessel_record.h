#pragma once
/// Loads on the vessel over a substep, and their means over the step.
#include <vector>

#include "contact/step_motion.h"
#include "core/sim/account/step_record.h"
#include "core/sim/step/substep.h"
#include "core/sim/world/world_state.h"

namespace nilas::sim {

/// Loads over a substep that ended at `t_end` [s]. `solved` and `frames` (AssembledContacts::C) belong to the same
/// substep.
VesselRecord vessel_record(const World& world, const Loads& loads, const contact::StepMotion& motion,
                           const contact::SolvedProblem& solved, const std::vector<Mat3>& frames, double t_end);

/// Adds the loads of a substep, weighted with its share of the step. States are those of the last substep.
void add_share(VesselRecord substep, double share, VesselRecord& step);

}  // namespace nilas::sim
