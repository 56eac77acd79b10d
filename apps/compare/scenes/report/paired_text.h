#pragma once
/// Paired differences in words.
#include <string>
#include <vector>

#include "apps/compare/scenes/judge/findings.h"

namespace nilas::compare {

/// The name in tables and JSON: "everywhere", "in realisations", "none" or "unknown".
const char* name_of(Certainty certainty);

/// The cell of a table [N], such as "+65 +- 10, significant"; empty without a difference. `reference_moves`: change of
/// the reference with its own step [N]; 0 for a difference from another setting, in which the reference has no part.
std::string difference_cell(const PairedDifference& difference, double reference_moves);

/// Sentences about the settings that differ significantly from `other` ("the reference"): in which realisations, and by
/// how much. Differences from the reference that are smaller than its own change are not named. `labels`: labels of all
/// settings.
std::vector<std::string> difference_lines(const Findings& found, PairedDifference Merit::*member,
                                          const std::string& other, const std::vector<std::string>& labels);

/// The realisations in words: "realisation 0", "realisations 0, 1 and 2".
std::string realisations_text(const std::vector<int>& realisations);

}  // namespace nilas::compare
