#pragma once
/// A module of one's own: a push.
#include <memory>

#include "core/bodies/module.h"

namespace nilas::output {

/// Makes the module of a constant force [N] at the centre of mass of each free body, over the first `steps` steps of a
/// run. Its state is the number of steps that are left, which is its column push_steps_left_1. The force does not
/// depend on the motion, so that no step is too long for it and nothing is limited.
std::unique_ptr<bodies::ForceModule> make_push(const Vec3& force, int steps);

}  // namespace nilas::output
