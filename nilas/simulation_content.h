#pragma once
/// What a Simulation holds.
#include <sys/types.h>

#include <atomic>
#include <memory>

#include "core/base/channels.h"
#include "core/base/log.h"
#include "core/output/tables/vessel_channels.h"
#include "core/sim/simulation.h"
#include "nilas/applied_loads.h"
#include "nilas/simulation.h"

namespace nilas {

struct Simulation::Content {
  Content(const Scene& of, const SimulationSettings& settings);

  /// A simulation at the start of the scene. `channels_of`: what its controllers set.
  std::unique_ptr<sim::Simulation> built(std::shared_ptr<Channels>& channels_of);

  /// Throws Error in a child of fork(), which has not the threads of its parent, and while another thread is within a
  /// call.
  class Use {
   public:
    explicit Use(const Content& content);
    ~Use();
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    std::atomic<bool>& in_use_;
  };

  Scene scene;
  SimulationSettings settings;
  pid_t process;
  mutable std::atomic<bool> in_use{false};
  std::shared_ptr<library::WaitingLoads> waiting;
  std::shared_ptr<Channels> commands;
  WarningCounts warning_counts;
  std::unique_ptr<sim::Simulation> simulation;
  std::optional<output::VesselChannels> channels;  ///< with a vessel
  sim::StepRecord last;                            ///< that of the last step
  bool has_failed = false;
};

}  // namespace nilas
