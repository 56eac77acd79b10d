#pragma once
/// Where the axes of drawings carry numbers.

namespace nilas {

/// Smallest of the steps 1, 2 and 5 times a power of ten that parts `length` into at most `at_most` intervals. Throws
/// ContractError unless both are positive.
double tick_step(double length, int at_most);

}  // namespace nilas
