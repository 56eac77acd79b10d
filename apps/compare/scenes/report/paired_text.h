#pragma once
/// Paired differences in words.
#include <string>
#include <vector>

#include "apps/compare/scenes/judge/findings.h"

namespace nilas {

/// "everywhere", "in realisations", "none", "unknown": as tables and JSON have it.
const char* name_of(Certainty certainty);

/// "+65 +- 10, significant": a table's cell in newton; empty of none.
std::string difference_cell(const PairedDifference& difference);

/// Which settings differ significantly from `other` ("the reference"), in which realisations, and by how much.
/// `labels`: of all settings.
std::vector<std::string> difference_lines(const Findings& found, PairedDifference Merit::*member,
                                          const std::string& other, const std::vector<std::string>& labels);

/// "realisation 0", "realisations 0, 1 and 2".
std::string realisations_text(const std::vector<int>& realisations);

}  // namespace nilas
