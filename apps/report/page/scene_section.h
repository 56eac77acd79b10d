#pragma once
/// The section of a report on what was run: facts and drawings.
#include "apps/report/page/run_findings.h"
#include "apps/report/page/section.h"

namespace nilas::report {

/// Notes gaps of the run where drawings cannot be made.
Section scene_section(RunFindings& found);

}  // namespace nilas::report
