#pragma once
/// The plots of a report as files for papers.
#include <filesystem>
#include <string>
#include <vector>

#include "apps/report/page/report_page.h"

namespace nilas::report {

/// Writes each plot of the page, and the load by place, as ID.svg and ID.pdf into the folder, which exists. Returns the
/// names of the files. Throws PlotError or FileError.
std::vector<std::string> write_figures(const ReportPage& page, const std::filesystem::path& folder);

}  // namespace nilas::report
