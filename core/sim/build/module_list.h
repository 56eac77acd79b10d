#pragma once
/// The list of all modules that a scene can ask for. Add a new module here.
#include <functional>
#include <string>
#include <vector>

#include "core/sim/build/module/module_sources.h"

namespace nilas::sim {

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
