#include "core/sim/step/take_step.h"

#include "core/sim/step/begin_substep.h"
#include "core/sim/step/choose_substep.h"
#include "core/sim/step/find_contacts.h"
#include "core/sim/step/loads.h"
#include "core/sim/step/move.h"
#include "core/sim/step/solve_contacts.h"
#include "core/sim/step/step_book.h"
#include "core/sim/step/substep_plan.h"
#include "fracture/model/step_end.h"

namespace nilas::sim {

/// Lets modules change bodies, for instance break floes. Pieces take part from the next step on.
static void end_step(World& world, StepBook& book) {
  const auto book_break = [&] { return world.energy.breaking(kinetic_energy(world.parts.bodies), world.potential()); };
  fracture::StepEnd end{world.parts.bodies, world.time(), world.step, world.solved.back(), book_break, {}, {}, {}};
  for (const auto& module : world.parts.modules) module->end_step(end);
  if (!end.broken.empty()) {
    world.follow_bodies(end.pieces);
    world.detector.follow(world.parts.bodies);
  }
  book.record().broken = std::move(end.broken);
  book.watch().lap(Phase::fracture);
}

StepRecord take_step(World& world) {
  StepBook book(world);
  SubstepPlan plan(world.time(), world.time_after(world.steps + 1), world.step, world.model.most_substeps);
  while (!plan.is_done()) {
    const bool first = plan.is_at_start();

    // The pose where the impulses act, and the loads other than contact there.
    const SubstepStart start = begin_substep(world, plan.now(), plan.longest());
    Loads loads = evaluate_loads(world, plan.now(), start.h);
    book.watch().lap(Phase::hydro);

    // The time until fast bodies meet, and the contacts that can close within it.
    const Substep substep = choose_substep(world, loads, plan.now(), start.h, plan.may_cut());
    FoundContacts found = find_contacts(world, loads, substep);
    book.note_found(found, first);
    book.watch().lap(Phase::detection);
    add_module_contacts(world, substep, found.points);
    book.watch().lap(Phase::fracture);

    // One value holds the contact problem; one set of residuals judges its solution.
    const bool can_halve = plan.can_halve(substep.h);
    const auto note = [&](const contact::ContactSolution& solution, const contact::Residuals& residuals) {
      book.note_solution(solution, residuals, substep.t + substep.h);
    };
    SolvedContacts solved = solve_contacts(world, loads, substep, std::move(found), can_halve, note, book.watch());
    if (!solved.unheld.empty() && can_halve) {
      take_back(world, start);
      plan.halve(substep.h);
      continue;
    }
    judge_unheld(world, substep, solved);

    // Velocities and poses, then the position correction that the scene chose.
    const contact::StepMotion motion = move(world, loads, substep, solved, start.vessel);
    const CorrectedPositions corrected = correct_positions(world, substep, solved, motion);
    plan.take(substep.h, start.h);
    book.add(substep, loads, std::move(solved), motion, corrected, start.vessel);
    for (const auto& module : world.parts.modules) module->end_substep(world.parts.bodies, plan.now(), substep.h);
  }
  ++world.steps;
  end_step(world, book);
  return book.close();
}

}  // namespace nilas::sim
