#pragma once
/// The steps between the numbers on the axes of drawings.

namespace nilas::report {

/// The smallest step of 1, 2 or 5 times a power of ten that divides `length` into at most `at_most` intervals. Throws
/// ContractError unless both are positive.
double tick_step(double length, int at_most);

}  // namespace nilas::report
