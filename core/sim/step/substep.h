#pragma once
/// A substep: the part of a step that one contact problem stands for. A step is one substep unless fast bodies meet in
/// it, or its solution would let them pass through each other.
#include "core/bodies/module.h"

namespace nilas {

struct Substep {
  double t = 0;                   ///< where it begins [s]
  double h = 0;                   ///< its length [s]
  bool ends_with_impact = false;  ///< it ends where the first fast bodies meet
};

/// Loads other than contact at the pose where the impulses act, with weight.
struct Loads {
  Wrenches total;                   ///< per body
  std::vector<Wrenches> by_module;  ///< in the order of WorldParts::forces
};

}  // namespace nilas
