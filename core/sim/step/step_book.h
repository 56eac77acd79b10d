#pragma once
/// What is written down of a step: energy, momentum, residuals, loads.
#include "contact/step_motion.h"
#include "core/sim/account/ledger.h"
#include "core/sim/account/step_record.h"
#include "core/sim/account/stopwatch.h"
#include "core/sim/step/move.h"
#include "core/sim/step/solve_contacts.h"
#include "core/sim/step/substep.h"
#include "core/sim/step/vessel_step.h"
#include "core/sim/world/world_state.h"

namespace nilas {

class StepBook {
 public:
  explicit StepBook(World& world);

  /// Contacts as they were found where a substep begins; `first` of the step. Their penetration is that of the step.
  void note_found(const FoundContacts& found, bool first);
  /// A solution, with a warning where it is short of the tolerance; `t_end` of its substep [s].
  void note_solution(const ContactSolution& solution, const Residuals& residuals, double t_end);
  /// A substep was taken: its accounts, its loads, and the problem for whoever asks for it later.
  void add(const Substep& substep, const Loads& loads, SolvedContacts solved, const StepMotion& motion,
           const CorrectedPositions& corrected, const VesselStart& vessel);
  /// The step is over.
  StepRecord close();

  Stopwatch& watch() { return watch_; }
  /// The record as far as it is written, for the modules' share of it.
  StepRecord& record() { return record_; }

 private:
  void keep(SolvedContacts& solved, const StepMotion& motion);

  World& world_;
  StepRecord record_;
  Stopwatch watch_;
  MomentumBalance balance_;
};

/// The parts of a record that are the same whatever moved the bodies: place in time, ledger, balance, state hash.
void note_end(const World& world, const MomentumBalance& balance, StepRecord& record);
/// Throws SimulationError where the scene stops at a step that the solver did not converge in.
void stop_on_failure(const World& world, const StepRecord& record);
/// The problem that stands for a step: of the last substep with contacts. Nothing before the first step.
const SolvedProblem* last_problem(const World& world);
/// Adds a solution's status and iterations to a record, with a warning where it is short of the tolerance.
void note_solution(World& world, const ContactSolution& solution, double t_end, StepRecord& record);
/// Warns once of every pair of materials that touches and that the scene does not name.
void warn_of_unnamed_pairs(World& world, const std::vector<ContactPoint>& points);

}  // namespace nilas
