#pragma once
/// Errors and costs of the settings of a comparison, from the table of its runs.
#include <functional>

#include "apps/compare/scenes/judge/findings.h"

namespace nilas::compare {

/// The error of a run in the measure's unit: its load difference, distance or turn; nothing if it is not known.
std::optional<double> measured_error(const RunRow& row, const Measure& measure);

/// The `value` of each run of the setting that is done in a shared realisation, as far as it is known.
std::vector<double> over_runs(const RunTable& rows, std::size_t setting, const std::vector<int>& shared,
                              const std::function<std::optional<double>(const RunRow&)>& value);

/// The merits, one per setting of the plan, without floors, dominance and paired differences.
std::vector<Merit> merits_of(const Plan& plan, const RunTable& rows, const Judges& judges,
                             const std::vector<int>& shared, const std::string& headline, const Measure& measure);

/// The relative standard deviation of computing times among runs of one setting, which do nearly the same work. It
/// shows how far a time can be trusted. NaN if no setting has two runs.
double time_spread(const Plan& plan, const RunTable& rows);

/// Sets Merit::time_spread from the relative one.
std::vector<Merit> with_time_spread(std::vector<Merit> merits, double relative);

}  // namespace nilas::compare
