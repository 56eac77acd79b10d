#pragma once
/// One run of a scene in a process of its own.
#include <filesystem>

#include "apps/compare/scenes/plan/setting.h"
#include "apps/compare/workshop/child.h"

namespace nilas::compare {

/// The input of a run of a comparison.
struct SceneRun {
  std::filesystem::path scene, folder, log;
  scene::Overrides overrides;  ///< overrides of the user, the setting and the realisation, in this order
  double end = 0;              ///< end of the simulated time [s]
  double sample_every = 0;     ///< time between stored states of all bodies [s]; 0: none are stored
};

/// The process of a run: `nilas run` on one thread, without the outputs that a comparison does not read.
ChildTask task_of(const SceneRun& run);

}  // namespace nilas::compare
