#pragma once
/// Vectors and attitudes at random.
#include "core/base/math.h"
#include "core/base/random.h"

namespace nilas::test {

/// A vector of three components with mean 0 and standard deviation 1.
inline Vec3 random_vector(RandomStream& random) {
  const double x = random.normal(), y = random.normal(), z = random.normal();
  return {x, y, z};
}

/// An attitude drawn evenly from all rotations.
inline Quat random_attitude(RandomStream& random) {
  // Compilers may evaluate the arguments of a call in any order, so that draws in them differ between compilers.
  const double z = random.normal(), y = random.normal(), x = random.normal(), w = random.normal();
  return Quat(w, x, y, z).normalized();
}

}  // namespace nilas::test
