#pragma once
/// A simulation with what was taken from its steps. One call of step() does all of it: Ctrl-C, which Python raises
/// between two calls, finds everything at the same step.
#include <pybind11/pybind11.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "nilas/simulation.h"

namespace nilas::python {

class Session {
 public:
  /// folder: where a run folder is written, if anywhere. keep_rows: whether the numbers of all steps are kept. Throws
  /// Error.
  Session(const Scene& scene, const SimulationSettings& settings, const std::optional<std::filesystem::path>& folder,
          bool force, bool keep_rows);

  /// Takes a step without Python's lock, writes it with that lock, and keeps its numbers if all are kept. Throws Error;
  /// then the run folder is finished as failed. Throws Error too where it is finished already.
  Step step();
  /// Finishes the run folder, once. Throws Error.
  void finish(const std::string& status, const std::string& message);
  /// Goes to a state, and forgets the rows of later steps. Throws Error, and where a run folder is being written.
  void restore(const Snapshot& snapshot);

  Simulation& simulation() { return simulation_; }
  const Simulation& simulation() const { return simulation_; }
  /// The numbers of all steps, one row after the other; empty where they are not kept.
  const std::vector<double>& rows() const { return rows_; }
  const std::vector<double>& vessel_rows() const { return vessel_rows_; }
  const std::optional<Step>& last() const { return last_; }

 private:
  Simulation simulation_;
  std::optional<RunWriter> writer_;
  bool is_finished_ = false;  ///< there was a run folder, and it is finished
  bool keep_rows_;
  std::vector<long> row_steps_;  ///< the number of the step of each row, which rises
  std::vector<double> rows_, vessel_rows_;
  std::optional<Step> last_;
};

}  // namespace nilas::python
