#pragma once
/// Contact problems of a run in FCLIB form, with the run's impulses: <folder>/problems/.
#include <filesystem>
#include <string>

#include "core/base/state.h"
#include "core/choices/output_choices.h"
#include "core/output/file/flush.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

/// Name under which the worst problem at the newest checkpoint is kept once a later problem is worse.
std::string kept_worst_name(long step);

/// Stores problems by the scene's <output problems>: never; every step with contacts (step-00000012.hdf5); every step
/// whose solver missed its tolerance (the same names); or the step with the largest law_map_m_s so far (worst.hdf5).
class ProblemFiles {
 public:
  /// `resumable`: the run is to write checkpoints.
  ProblemFiles(const std::filesystem::path& run_folder, StoredProblems which, bool resumable);

  /// Throws FileError.
  void step(const sim::StepRecord& record, const contact::SolvedProblem& solved);
  /// Stores the problem at which values ceased to be finite as last.hdf5, whatever the scene asks for. Throws
  /// FileError.
  void last(const contact::SolvedProblem& solved);

  /// Returns when all problems are on the disk. Throws FileError.
  void sync() { unflushed_.flush(); }
  /// Saves which step's problem is the worst so far.
  void save(StateWriter out) const;
  void restore(const StateReader& in);
  /// Notes that the state of save() is on disk. From now on the worst problem of that state is kept, under its own name
  /// once a worse one replaces it. The one kept for an older state is removed. Throws FileError.
  void saved();
  /// Step of the worst problem; -1: there is none.
  long worst_step() const { return worst_step_; }

 private:
  void keep_worst() const;
  void write(const std::string& name, const contact::SolvedProblem& solved);

  std::filesystem::path folder_;
  StoredProblems which_;
  UnflushedFiles unflushed_;
  double worst_ = -1;                             ///< law_map_m_s of the stored problem [m/s]
  long worst_step_ = -1, saved_worst_step_ = -1;  ///< step of worst.hdf5; that in the newest checkpoint
};

}  // namespace nilas::output
