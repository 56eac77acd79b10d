#pragma once
/// The modules that a scene can ask for: the one list to which a new one is added.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/log.h"
#include "core/bodies/module.h"
#include "core/scene/scene.h"
#include "core/sim/world/world.h"

namespace nilas {

/// What modules are built from. A module may refer to `parts.ice_properties` and to `warnings`, which outlive it, and
/// must copy everything else.
struct ModuleSources {
  const Scene& scene;
  const WorldParts& parts;  ///< all bodies are there
  int threads;
  WarningCounts& warnings;
};

struct BuiltModule {
  std::unique_ptr<Module> module;  ///< nothing where the scene does not ask for it
  std::string reason;              ///< the element that asks for it, for the list of what was built and why
};

struct ModuleEntry {
  std::string name;
  bool listed = true;  ///< in the lists of what was built and what was not; false: it only serves another module
  std::function<BuiltModule(const ModuleSources&)> build;
};

/// Modules in the order in which a step calls them.
using ModuleList = std::vector<ModuleEntry>;

/// The modules of this program: loads, then contacts, then what happens at a step's end.
const ModuleList& scene_modules();

}  // namespace nilas
