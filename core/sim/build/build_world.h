#pragma once
/// From a scene to everything that a run moves.
#include "core/base/log.h"
#include "core/scene/scene.h"
#include "core/sim/build/module_list.h"
#include "core/sim/world/world.h"

namespace nilas {

/// Builds all parts and, of `modules`, those that the scene asks for. `warnings` must outlive the result. Throws
/// InputError, FileError for content that cannot run.
WorldParts build_world(const Scene& scene, int threads, WarningCounts& warnings,
                       const ModuleList& modules = scene_modules());

}  // namespace nilas
