#pragma once
/// A substep: the interval of one contact problem. A step is one substep unless fast bodies meet in it, or its solution
/// would let them pass through each other.
#include "core/bodies/module.h"

namespace nilas::sim {

struct Substep {
  double t = 0;                   ///< start [s]
  double h = 0;                   ///< length [s]
  bool ends_with_impact = false;  ///< true if it ends where the first fast bodies meet
};

/// Loads other than contact, weight included, at the pose where the impulses act.
struct Loads {
  bodies::Wrenches total;                   ///< load per body
  std::vector<bodies::Wrenches> by_module;  ///< same order as WorldParts::forces
};

}  // namespace nilas::sim
