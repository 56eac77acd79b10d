#pragma once
/// The sections of a report on the loads over time: curves, spectra, statistics.
#include "apps/report/page/run_findings.h"
#include "apps/report/page/section.h"

namespace nilas::report {

Section loads_section(const RunFindings& found);
Section spectra_section(const RunFindings& found);
Section statistics_section(const RunFindings& found);

/// The curves of one run that its own page and a comparison draw. `factor`: of the loads' unit, 1e-3 for kN; `name`: in
/// the legend.
Curve along_curve(const RunFindings& found, const std::string& name, double factor);
/// Empty where the window is too short.
std::optional<Curve> spectrum_curve(const std::vector<double>& series, const BodyLoad& load, double step,
                                    const std::string& name, double factor);

}  // namespace nilas::report
