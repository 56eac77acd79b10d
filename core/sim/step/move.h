#pragma once
/// Moves the bodies with the velocities that the impulses give.
#include "contact/step_motion.h"
#include "core/sim/step/solve_contacts.h"
#include "core/sim/step/substep.h"
#include "core/sim/step/vessel_step.h"
#include "core/sim/world/world_state.h"

namespace nilas::sim {

/// Moves all bodies to the substep's end with the velocities of the solution. Returns the impulses and the velocities
/// before and after them. Takes the contact points out of `solved`.
contact::StepMotion move(World& world, Loads& loads, const Substep& substep, SolvedContacts& solved,
                         const VesselStart& vessel);

struct CorrectedPositions {
  contact::Velocities pseudo;  ///< velocities of the displacement over the substep; empty without a correction
  bool converged = true;
};

/// Reduces penetration by displacing the bodies, where the scene asks for it.
CorrectedPositions correct_positions(World& world, const Substep& substep, const SolvedContacts& solved,
                                     const contact::StepMotion& motion);

}  // namespace nilas::sim
