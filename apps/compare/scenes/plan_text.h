#pragma once
/// A comparison's plan in words, before it starts.
#include <string>
#include <vector>

#include "apps/compare/scenes/study_folder.h"

namespace nilas {

/// A line per sentence.
std::vector<std::string> plan_lines(const Study& study);

}  // namespace nilas
