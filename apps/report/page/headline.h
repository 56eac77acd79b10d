#pragma once
/// The sentences with which a report begins.
#include <string>
#include <vector>

#include "apps/report/page/run_findings.h"

namespace nilas::report {

/// What a reader needs first: the mean load, the largest, and how sure the mean is; then where the largest load acted
/// and which ice made it, and what limits the answer. Each entry is a paragraph of whole sentences.
std::vector<std::string> headline(const RunFindings& found);

/// The address of the moment of the largest load in the page of `nilas view`, to the floe that made it:
/// "replay.html#t=34.2&pick=17"; empty without a load.
std::string peak_address(const RunFindings& found);

}  // namespace nilas::report
