#pragma once
/// Loads that the user of the library sets from outside, for one step.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/bodies/module.h"

namespace nilas::library {

struct AppliedLoad {
  std::int64_t body = 0;  ///< its id
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
  Vec3 arm = Vec3::Zero();  ///< from the centre of mass to where the force acts, when it was applied, frame G [m]
};

/// The loads that wait for the next step. Whoever takes the step clears them after it.
using WaitingLoads = std::vector<AppliedLoad>;

/// Makes the module. It adds every waiting load to its body, and none to a body that is gone.
std::unique_ptr<bodies::Module> make_applied_loads(std::shared_ptr<WaitingLoads> waiting);

}  // namespace nilas::library
