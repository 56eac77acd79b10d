#pragma once
/// A comparison's plan in words, before it starts.
#include <string>
#include <vector>

#include "apps/compare/scenes/run/scene_study.h"

namespace nilas {

/// A line per sentence.
std::vector<std::string> plan_lines(const SceneStudy& study);

/// States that all runs are compared over less simulated time than until `before`, since they take `factor` times what
/// was measured.
std::string shorter_line(const Plan& plan, double before, double factor);

}  // namespace nilas
