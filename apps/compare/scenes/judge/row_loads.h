#pragma once
/// The windows over which runs of one realisation are summed up, the same one for all of them.
#include <filesystem>

#include "apps/compare/scenes/judge/merits.h"

namespace nilas {

/// Sets Findings::windows and RunRow::loads. The window of a realisation is that of the run that judges it, else of the
/// first setting, else of any run of it that is done; its start is moved back to an end of the coarsest step, so that
/// all steps count the same time. `folder`: runs/<id>/ice_load.csv lie there. Throws FileError.
void measure_row_loads(const Plan& plan, const std::filesystem::path& folder, Findings& found);

}  // namespace nilas
