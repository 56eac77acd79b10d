#pragma once
/// Which settings of a comparison are worth their time.
#include "apps/compare/scenes/judge/findings.h"

namespace nilas {

/// Sets Merit::dominated where another setting is no slower and no worse, and better in one of both. Errors below the
/// floor count as equal.
std::vector<Merit> with_dominance(std::vector<Merit> merits);

/// Chosen is the fastest setting that is good enough; of those whose times cannot be told apart the most accurate, and
/// the scene's own setting where it is one of them.
Choice choose(const std::vector<Merit>& merits, const Measure& measure, double common_floor, double time_spread);

/// The p of errors C h^p, where three steps or more have a significant error and the rest is the same; of errors
/// C (h^p - r^p) where the reference is of the same integrator and has a step r itself.
std::vector<Order> orders_of(const Plan& plan, const Findings& found);

/// Whether the error of any setting is known.
bool anything_compared(const std::vector<Merit>& merits);

}  // namespace nilas
