#pragma once
/// The page that compares several runs.
#include <memory>
#include <vector>

#include "apps/report/page/report_page.h"

namespace nilas::report {

/// Two or more runs side by side: loads with differences from the first and their errors, differing attributes of the
/// scenes, and curves of all runs over each other. The runs must outlive the page.
ReportPage comparison_page(const std::vector<std::unique_ptr<RunFindings>>& runs);

}  // namespace nilas::report
