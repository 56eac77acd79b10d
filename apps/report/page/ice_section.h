#pragma once
/// The section of a report on the ice ahead.
#include "apps/report/figures/ice_cover.h"
#include "apps/report/page/run_findings.h"
#include "apps/report/page/section.h"

namespace nilas::report {

/// The window ahead of the body that a report is about at time t [s]; empty where its shape or course is not known.
std::optional<WaterWindow> window_ahead(const RunFindings& found, double t);

/// The share of ice in the window ahead over time, in percent; empty where it cannot be found. Throws FileError or
/// InputError for a frame that cannot be read.
std::optional<Curve> cover_curve(const RunFindings& found, const std::string& name);

/// Notes a gap of the run where a frame cannot be read.
Section ice_section(RunFindings& found);

}  // namespace nilas::report
