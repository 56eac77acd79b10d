#pragma once
/// What runs are said to be off in their mean load, beside what they are. Method: docs/theory/compare.md.
#include "apps/compare/scenes/judge/merits.h"

namespace nilas {

/// How estimates hold against measured errors, one of each per run. `rounding`: errors below it count as none.
Coverage coverage(const std::vector<double>& estimates, const std::vector<double>& measured, double rounding);

/// Gives each run of the grid its parts and counts how many hold. `chaos`: of the difference of two runs of one
/// realisation, 95 %; NaN: not measured [N].
void judge_load_errors(const Plan& plan, double chaos, Findings& found);

}  // namespace nilas
