#pragma once
/// From impulses to velocities and poses.
#include "contact/step_motion.h"
#include "core/sim/step/solve_contacts.h"
#include "core/sim/step/substep.h"
#include "core/sim/step/vessel_step.h"
#include "core/sim/world/world_state.h"

namespace nilas {

/// Moves all bodies to the substep's end with the velocities of the solution. Returns the velocities around the
/// impulses, and the impulses; the contact points go from `solved` to it.
StepMotion move(World& world, const Loads& loads, const Substep& substep, SolvedContacts& solved,
                const VesselStart& vessel);

struct CorrectedPositions {
  Velocities pseudo;  ///< that the bodies were displaced with over the substep; empty without a correction
  bool converged = true;
};

/// Takes back what penetration there is by displacing the bodies, where the scene asks for that.
CorrectedPositions correct_positions(World& world, const Substep& substep, const SolvedContacts& solved,
                                     const StepMotion& motion);

}  // namespace nilas
