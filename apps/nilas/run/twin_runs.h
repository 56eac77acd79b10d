#pragma once
/// The perturbed runs of a scene, which advance in step with it.
#include <memory>
#include <vector>

#include "core/output/loads/load_window.h"
#include "core/output/loads/twin_statistics.h"
#include "core/output/tables/vessel_channels.h"
#include "core/sim/simulation.h"

namespace nilas::commands {

class TwinRuns {
 public:
  /// Builds `count` perturbed runs of the scene that `itself` was built from. Their numbers follow the scene's own.
  /// Throws as Simulation does.
  TwinRuns(const scene::Scene& scene, const sim::Simulation& itself, int count, int threads);
  ~TwinRuns();

  /// Advances the scene and each perturbed run by a step, in parallel on the threads. Returns the scene's record.
  /// Throws what `itself` throws. A perturbed run whose numerics fail stops and is recorded as failed.
  sim::StepRecord step(sim::Simulation& itself);

  /// The statistics of the mean loads over the window, of the scene and its perturbed runs, and their horizon.
  output::TwinStatistics statistics(const output::LoadWindow& window) const;

 private:
  struct Twin;
  using LoadSeries = std::vector<std::vector<double>>;  ///< one list per load, one value per step
  void note_loads(const sim::StepRecord& record, LoadSeries& series) const;

  output::VesselChannels channels_;
  int threads_;
  LoadSeries loads_;  ///< the loads of the scene itself
  std::vector<std::unique_ptr<Twin>> twins_;
  output::TwinHorizon horizon_;
};

}  // namespace nilas::commands
