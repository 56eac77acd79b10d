#pragma once
/// Records a step: energy, momentum, residuals, loads.
#include "contact/step_motion.h"
#include "core/sim/account/ledger.h"
#include "core/sim/account/step_record.h"
#include "core/sim/account/stopwatch.h"
#include "core/sim/step/move.h"
#include "core/sim/step/solve_contacts.h"
#include "core/sim/step/substep.h"
#include "core/sim/step/vessel_step.h"
#include "core/sim/world/world_state.h"

namespace nilas::sim {

class StepBook {
 public:
  explicit StepBook(World& world);

  /// Notes the contacts at the start of a substep. `first`: of the first substep, whose penetration is that of the
  /// step.
  void note_found(const FoundContacts& found, bool first);
  /// Notes a solution, with a warning where it misses the tolerance. `t_end`: end of its substep [s].
  void note_solution(const contact::ContactSolution& solution, const contact::Residuals& residuals, double t_end);
  /// Books a substep that was taken: its accounts, its loads and its solved problem.
  void add(const Substep& substep, const Loads& loads, SolvedContacts solved, const contact::StepMotion& motion,
           const CorrectedPositions& corrected, const VesselStart& vessel);
  /// Ends the step and returns its record.
  StepRecord close();

  Stopwatch& watch() { return watch_; }
  /// The record so far, so that modules can add to it.
  StepRecord& record() { return record_; }

 private:
  void keep(SolvedContacts& solved, const contact::StepMotion& motion);

  World& world_;
  StepRecord record_;
  Stopwatch watch_;
  MomentumBalance balance_;
};

/// Fills the entries of a record that do not depend on the integrator: time, ledger, balance, state hash.
void note_end(const World& world, const MomentumBalance& balance, StepRecord& record);
/// Throws SimulationError where the solver did not converge and the scene asks to stop.
void stop_on_failure(const World& world, const StepRecord& record);
/// The problem that represents a step: that of the last substep with contacts. Null before the first step.
const contact::SolvedProblem* last_problem(const World& world);
/// Adds a solution's status and iterations to a record, with a warning where it misses the tolerance.
void note_solution(World& world, const contact::ContactSolution& solution, double t_end, StepRecord& record);
/// Warns once of every pair of materials in contact that the scene does not name.
void warn_of_unnamed_pairs(World& world, const std::vector<detect::ContactPoint>& points);

}  // namespace nilas::sim
