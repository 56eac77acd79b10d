#pragma once
/// Estimated errors of mean loads, and how well they agree with measured ones. Method: docs/theory/compare.md.
#include "apps/compare/scenes/judge/findings.h"

namespace nilas::compare {

/// How well estimates agree with measured errors, one of each per run. `rounding`: errors below it count as none.
Coverage coverage(const std::vector<double>& estimates, const std::vector<double>& measured, double rounding);

struct LoadErrors {
  std::vector<std::optional<LoadErrorParts>> of_rows;  ///< one per row; nothing if it is not known
  std::optional<Coverage> coverage;                    ///< coverage of all parts together
  std::optional<Coverage> coverage_alone;              ///< coverage of the estimate that each run states by itself
};

/// The load errors of the runs of the settings, from the rows, merits, chance and step check found so far.
LoadErrors load_errors(const Plan& plan, const Findings& found);

}  // namespace nilas::compare
