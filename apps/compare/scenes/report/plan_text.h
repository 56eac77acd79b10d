#pragma once
/// A comparison's plan in words, before it starts.
#include <string>
#include <vector>

#include "apps/compare/scenes/run/study_folder.h"

namespace nilas {

/// A line per sentence.
std::vector<std::string> plan_lines(const Study& study);

/// That all runs are told over less time than until `before`, as they take `factor` times what was measured.
std::string shorter_line(const Plan& plan, double before, double factor);

}  // namespace nilas
