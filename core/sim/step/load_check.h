#pragma once
/// The ice load of a substep beside that of a second, strict solution of the same problem.
#include <optional>

#include "contact/step_motion.h"
#include "core/sim/account/step_record.h"
#include "core/sim/step/solve_contacts.h"
#include "core/sim/world/world_state.h"

namespace nilas::sim {

/// Solves the substep's problem again, from its own impulses, and adds both loads to `check`. Pyramids of friction
/// become exact cones. Only islands in which ice touches what bears the load are solved; without any, `check` stays as
/// it is. `solved` has its problem and solution, `motion` its points. The motion does not change.
void check_load(const World& world, const SolvedContacts& solved, const contact::StepMotion& motion,
                std::optional<LoadCheck>& check);

}  // namespace nilas::sim
