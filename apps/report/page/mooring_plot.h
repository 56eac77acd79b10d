#pragma once
/// The tensions of mooring lines over time.
#include <optional>

#include "apps/report/page/run_findings.h"
#include "apps/report/page/section.h"

namespace nilas::report {

/// A plot of the tensions with its sentence on the largest one.
struct MooringPlot {
  Plot plot;
  std::string text;
};

/// The lines with the largest tensions, the largest first; beyond eight the others are one curve with their range.
/// Empty where steps.csv has no tensions of lines.
std::optional<MooringPlot> mooring_plot(const RunFindings& found);

}  // namespace nilas::report
