#pragma once
/// Numbers that stand for something else than a value.
#include <limits>

namespace nilas::compare {

/// A figure that was not measured.
constexpr double k_unknown = std::numeric_limits<double>::quiet_NaN();
/// A limit that does not exist.
constexpr double k_infinity = std::numeric_limits<double>::infinity();

}  // namespace nilas::compare
