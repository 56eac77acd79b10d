#pragma once
/// A scene's twins, run in step with it.
#include <memory>
#include <vector>

#include "core/output/loads/load_window.h"
#include "core/output/loads/twin_statistics.h"
#include "core/output/tables/vessel_channels.h"
#include "core/sim/simulation.h"

namespace nilas {

class TwinRuns {
 public:
  /// `count` twins of a scene that `itself` was built of, numbered on from its own. Throws as Simulation does.
  TwinRuns(const Scene& scene, const Simulation& itself, int count, int threads);
  ~TwinRuns();

  /// A step of the scene and of each twin, side by side on so many threads. Throws what `itself` throws; a twin whose
  /// numerics fail goes no further.
  StepRecord step(Simulation& itself);

  /// Means over the window.
  TwinStatistics statistics(const LoadWindow& window) const;

 private:
  struct Twin;
  using LoadSeries = std::vector<std::vector<double>>;  ///< per load one value per step
  void note_loads(const StepRecord& record, LoadSeries& series) const;

  VesselChannels channels_;
  int threads_;
  LoadSeries loads_;  ///< the scene's own
  std::vector<std::unique_ptr<Twin>> twins_;
  TwinHorizon horizon_;
};

}  // namespace nilas
