#pragma once
/// One run of a scene in a process of its own.
#include <filesystem>

#include "apps/compare/scenes/plan/setting.h"
#include "apps/compare/workshop/child.h"

namespace nilas {

/// What a run of a comparison is made with.
struct SceneRun {
  std::filesystem::path scene, folder, log;
  Overrides overrides;      ///< of the user, the setting and the realisation, in this order
  double end = 0;           ///< simulated [s]
  double sample_every = 0;  ///< between stored states of all bodies; 0: none are stored [s]
};

/// `nilas run`, one thread, without the outputs that a comparison does not read.
ChildTask task_of(const SceneRun& run);

}  // namespace nilas
