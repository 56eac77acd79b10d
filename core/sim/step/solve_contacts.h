#pragma once
/// The contact problem of a substep and its solution.
#include <functional>
#include <utility>
#include <vector>

#include "contact/assemble.h"
#include "contact/measure/measure.h"
#include "contact/step_motion.h"
#include "core/sim/account/stopwatch.h"
#include "core/sim/step/find_contacts.h"
#include "core/sim/step/substep.h"
#include "core/sim/world/world_state.h"

namespace nilas {

struct SolvedContacts {
  FoundContacts found;
  AssembledContacts contacts;
  ContactSolution solution;
  Residuals residuals;
  std::vector<double> d;      ///< per contact, as from `measure` [1/kg]
  SlippingContacts slipping;  ///< for the next step
  Velocities after;           ///< that were solved for, of free bodies and vessel
  /// Fast pairs that the solution leads into each other although all tries were spent.
  std::vector<std::pair<int, int>> unheld;
};

/// Told of every solution, also of those that lead fast pairs into each other and are replaced.
using NoteSolution = std::function<void(const ContactSolution&, const Residuals&)>;

/// Assembles and solves the substep's problem. Where the solution leads fast pairs into each other, their contacts on
/// the way are added and it is solved again. `can_halve`: fewer tries, since a shorter substep may follow.
SolvedContacts solve_contacts(World& world, const Loads& loads, const Substep& substep, FoundContacts found,
                              bool can_halve, const NoteSolution& note, Stopwatch& watch);

/// What the solution could not hold stays as a penetration, with a warning, or is refused where a body would pass
/// through another. Throws SimulationError.
void judge_unheld(World& world, const Substep& substep, const SolvedContacts& solved);

/// The velocities of the free bodies after the impulses; others keep what they have.
Velocities new_velocities(const World& world, const AssembledContacts& contacts, const ContactSolution& solution,
                          const Loads& loads, double h);

}  // namespace nilas
