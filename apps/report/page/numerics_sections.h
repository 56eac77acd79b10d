#pragma once
/// The sections of a report on what the program did: energy, solver, time, breaks.
#include "apps/report/page/run_findings.h"
#include "apps/report/page/section.h"

namespace nilas::report {

Section breaks_section(const RunFindings& found);
Section energy_section(const RunFindings& found);
Section solver_section(const RunFindings& found);
Section time_section(const RunFindings& found);

}  // namespace nilas::report
