#include "python/binding/session.h"

#include <algorithm>

namespace nilas::python {

Session::Session(const Scene& scene, const SimulationSettings& settings,
                 const std::optional<std::filesystem::path>& folder, bool force, bool keep_rows)
    : simulation_(scene, settings), keep_rows_(keep_rows) {
  if (folder) writer_.emplace(simulation_, *folder, force);
}

Step Session::step() {
  if (is_finished_)
    throw Error(ErrorKind::input, "the run folder is finished; a simulation that goes on needs one of its own");
  try {
    Step step;
    {
      const pybind11::gil_scoped_release without_lock;
      step = simulation_.step();
    }
    // The HDF5 library is not made for several threads, and other packages of Python use it under the lock.
    if (writer_) writer_->record();
    if (keep_rows_) {
      row_steps_.push_back(step.number);
      rows_.insert(rows_.end(), step.numbers.begin(), step.numbers.end());
      vessel_rows_.insert(vessel_rows_.end(), step.vessel_numbers.begin(), step.vessel_numbers.end());
    }
    last_ = step;
    return step;
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::input) finish("failed", e.what());
    throw;
  }
}

void Session::finish(const std::string& status, const std::string& message) {
  if (!writer_) return;
  std::optional<RunWriter> ending = std::move(writer_);
  writer_.reset();
  is_finished_ = true;
  ending->finish(status, message);
}

void Session::restore(const Snapshot& snapshot) {
  if (writer_) throw Error(ErrorKind::input, "a simulation that writes a run folder cannot go back in time");
  simulation_.restore(snapshot);
  // A state of another simulation may lie ahead of all rows, so that these do not begin with the first step.
  const auto later = std::upper_bound(row_steps_.begin(), row_steps_.end(), simulation_.steps());
  row_steps_.erase(later, row_steps_.end());
  rows_.resize(row_steps_.size() * simulation_.step_columns().size());
  vessel_rows_.resize(row_steps_.size() * simulation_.vessel_columns().size());
  last_.reset();
}

}  // namespace nilas::python
