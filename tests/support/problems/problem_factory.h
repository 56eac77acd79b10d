#pragma once
/// Contact problems for tests: rigid bodies, random heaps, columns, rafts of floes, stacks.
#include "contact/challenge/challenge_problems.h"

namespace nilas::test {

using namespace nilas::challenge;
using TestBody = challenge::RigidBody;

}  // namespace nilas::test
