#pragma once
/// Loads of the runs of a comparison over the same time, and how far they differ.
#include <filesystem>

#include "apps/compare/scenes/judge/findings.h"

namespace nilas::compare {

/// The window of each realisation, over which the loads of all its runs are taken: that of the run that judges it, else
/// of the first setting, else of any run that is done. Its start is moved back to an end of the coarsest step, so that
/// all steps cover the same time. The list is empty without a headline channel.
std::vector<std::optional<output::LoadSpan>> windows_of(const Plan& plan, const RunTable& rows,
                                                        const std::string& headline);

/// Sets RunRow::loads from runs/<id>/ice_load.csv of the comparison's folder. Throws FileError.
RunTable with_loads(const Plan& plan, const std::vector<std::optional<output::LoadSpan>>& windows,
                    const std::filesystem::path& folder, RunTable rows);

/// Sets RunRow::load_difference and RunRow::own_difference.
RunTable with_load_differences(const Plan& plan, const std::string& headline, RunTable rows);

/// The loads of the runs that judge the shared realisations.
JudgingLoads reference_loads(const RunTable& rows, const std::string& headline, const std::vector<int>& shared);

}  // namespace nilas::compare
