#pragma once
/// The plan of a comparison in words, for the terminal before it starts.
#include <string>
#include <vector>

#include "apps/compare/scenes/run/scene_study.h"

namespace nilas::compare {

/// The plan, one statement per line. `left_s`: wall time that the budget has left for the runs [s]; infinite: there is
/// no budget. Says so where the runs are expected to take more.
std::vector<std::string> plan_lines(const SceneStudy& study, double left_s);

/// States that all runs are compared over less simulated time than up to `before` [s], because they take `factor` times
/// as long as measured.
std::string shorter_line(const Plan& plan, double before, double factor);

}  // namespace nilas::compare
