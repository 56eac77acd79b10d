#pragma once
/// Places in vectors that hold three numbers per contact.
#include "core/base/math.h"

namespace nilas::contact {

/// The first of the three rows of contact `c`, in the order (N, T1, T2).
inline Eigen::Index row_of(Eigen::Index c) { return 3 * c; }

}  // namespace nilas::contact
