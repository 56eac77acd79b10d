#pragma once
/// Builds everything that a run moves from a scene.
#include "core/base/log.h"
#include "core/scene/scene.h"
#include "core/sim/build/module_list.h"
#include "core/sim/world/world.h"

namespace nilas::sim {

/// Builds bodies and models, and those of `modules` that the scene asks for. `warnings` must outlive the result. Throws
/// InputError and FileError for content that cannot run.
WorldParts build_world(const scene::Scene& scene, int threads, WarningCounts& warnings,
                       const ModuleList& modules = scene_modules());

}  // namespace nilas::sim
