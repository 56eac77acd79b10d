#pragma once
/// v = M^-1 (f + H r) whose bits do not depend on the order of contacts or bodies.
#include "contact/problem/prepared_problem.h"

namespace nilas::solvers {

/// Each block's sum is an OrderFreeSum: mirrored problems give the mirrored velocities to the last bit.
VecX order_free_velocities(const contact::PreparedProblem& prepared, const VecX& r);

}  // namespace nilas::solvers
