#pragma once
/// The page of a report.
#include <string>
#include <vector>

#include "apps/report/page/place_sections.h"
#include "apps/report/page/run_findings.h"
#include "apps/report/page/section.h"

namespace nilas::report {

struct ReportPage {
  std::string title;                  ///< plain text
  std::vector<std::string> headline;  ///< paragraphs of whole sentences
  std::string see;                    ///< how to see the largest load in motion; empty: there is none
  std::string address;                ///< address of that moment in replay.html; empty: the file is not there
  std::vector<Section> sections;
  std::optional<HullPicture> hull;  ///< refers to what the page was made from
};

/// All sections of the report on one run. `found` must outlive the page. `beside_run`: the page will lie in the run
/// folder, so that it may lead to replay.html there.
ReportPage report_page(RunFindings& found, bool beside_run);

/// The page as one HTML text that needs nothing else. Throws InputError where the program was built without pages.
std::string page_html(const ReportPage& page);

}  // namespace nilas::report
