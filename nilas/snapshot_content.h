#pragma once
/// What a Snapshot holds.
#include <string>

#include "core/base/state.h"
#include "nilas/applied_loads.h"
#include "nilas/simulation.h"

namespace nilas {

struct Snapshot::Content {
  State state;
  std::string fingerprint;  ///< of its scene
  bool applied_loads = false;
  library::WaitingLoads waiting;  ///< loads of the next step
};

}  // namespace nilas
