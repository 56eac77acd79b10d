#pragma once
/// The list of all modules that a scene can ask for. Add a new module here.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/log.h"
#include "core/bodies/module.h"
#include "core/scene/scene.h"
#include "core/sim/world/world.h"

namespace nilas::sim {

/// The sources from which modules are built. A module may refer to `parts.ice_properties` and `warnings`, which outlive
/// it, and must copy everything else.
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

struct ModuleEntry {
  std::string name;
  bool listed = true;  ///< true: shown in the lists of what was and was not built; false: only serves another module
  std::function<BuiltModule(const ModuleSources&)> build;
};

/// Modules in the order in which a step calls them.
using ModuleList = std::vector<ModuleEntry>;

/// The modules of this program: loads, then contacts, then what happens at a step's end.
const ModuleList& scene_modules();

}  // namespace nilas::sim
