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

namespace nilas::sim {

struct SolvedContacts {
  FoundContacts found;
  contact::AssembledContacts contacts;
  VecX guess;  ///< impulses that the solver began with, empty without a warm start [N s]
  contact::ContactSolution solution;
  int num_islands = 0;
  contact::Residuals residuals;
  std::vector<double> d;               ///< per contact, as returned by `measure` [1/kg]
  contact::SlippingContacts slipping;  ///< contacts that slip, for the next step
  contact::Velocities after;           ///< velocities after the impulses, of free bodies and vessel
  /// Fast pairs that the solution leads into each other after the last try.
  std::vector<std::pair<int, int>> unheld;
};

/// Called with every solution, including those that lead fast pairs into each other and are replaced.
using NoteSolution = std::function<void(const contact::ContactSolution&, const contact::Residuals&)>;

/// Assembles and solves the substep's problem. Where the solution leads fast pairs into each other, their contacts on
/// the path are added and the problem is solved again. `can_halve`: fewer tries, since a shorter substep may follow.
SolvedContacts solve_contacts(World& world, const Loads& loads, const Substep& substep, FoundContacts found,
                              bool can_halve, const NoteSolution& note, Stopwatch& watch);

/// Handles the pairs that the solution could not hold apart: warns and leaves a penetration. Throws SimulationError
/// where a body would pass through another.
void judge_unheld(World& world, const Substep& substep, const SolvedContacts& solved);

/// The velocities of the free bodies after the impulses; other bodies keep theirs.
contact::Velocities new_velocities(const World& world, const contact::AssembledContacts& contacts,
                                   const contact::ContactSolution& solution, const Loads& loads, double h);

}  // namespace nilas::sim
