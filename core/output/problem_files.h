#pragma once
/// Contact problems of a run in FCLIB form, with the impulses that the run used: <folder>/problems/.
#include <filesystem>
#include <string>

#include "core/base/state.h"
#include "core/sim/step_record.h"

namespace nilas {

/// Stores what the scene's <output problems> asks for: never; every step with contacts (step-00000012.hdf5); every step
/// whose solver missed its tolerance (the same names); or the step with the largest law_map_m_s so far (worst.hdf5).
class ProblemFiles {
 public:
  ProblemFiles(const std::filesystem::path& run_folder, const std::string& which);

  /// Throws FileError.
  void step(const StepRecord& record, const SolvedProblem& solved);
  /// The problem at which the world left finite numbers, as last.hdf5, whatever the scene asks for. Throws FileError.
  void last(const SolvedProblem& solved) const;

  /// Which step's problem is the worst so far. Files of later steps are written again.
  void save(StateWriter out) const { out.add("worst_law_map_m_s", worst_); }
  void restore(const StateReader& in) { in.get("worst_law_map_m_s", worst_); }

 private:
  void write(const std::string& name, const SolvedProblem& solved) const;

  std::filesystem::path folder_;
  std::string which_;
  double worst_ = -1;  ///< law_map_m_s of the stored one [m/s]
};

}  // namespace nilas
