#pragma once
/// What a builder of modules gets and returns.
#include <memory>
#include <string>

#include "core/base/log.h"
#include "core/bodies/module.h"
#include "core/scene/scene.h"
#include "core/sim/world/world.h"

namespace nilas::sim {

/// The sources from which modules are built. A module may refer to `parts.ice_properties` and `warnings`, which outlive
/// it, may keep the pointer `parts.commands`, and must copy everything else.
struct ModuleSources {
  const scene::Scene& scene;
  const WorldParts& parts;  ///< its bodies are complete
  int threads;
  WarningCounts& warnings;
};

struct BuiltModule {
  std::unique_ptr<bodies::Module> module;  ///< null where the scene does not ask for it
  std::string reason;                      ///< the element that asks for it, for the list of what was built and why
};

}  // namespace nilas::sim
