#pragma once
/// Contact problems that a scene meets: the hardest one, and those of its last steps.
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "contact/problem/problem.h"

namespace nilas::compare {

struct HardestStep {
  contact::ContactProblem problem;
  double time = 0;  ///< end of the step [s]
  int iterations = 0;
};

/// Runs a scene up to a time [s] on one thread and returns its hardest step. It is the one with most iterations of the
/// solver, and of these the one with most contacts. Steps with a contact between bodies that cannot move are left out,
/// because no file can hold them. Nothing if bodies never touch, or as soon as `stop` turns true. Throws SceneError,
/// InputError, FileError.
std::optional<HardestStep> hardest_step(const std::filesystem::path& scene, double until,
                                        const std::function<bool()>& stop);

/// A step's contact problem with the impulses that the solver began with.
struct StoredStep {
  contact::ContactProblem problem;
  VecX guess;       ///< empty without a warm start
  double time = 0;  ///< end of the step [s]
  int step = 0;     ///< steps done, this one included
};

/// Runs a scene up to a time [s] or its end on one thread and returns its last step and those 5 and 10 steps before.
/// Steps in which bodies do not touch, or with a contact between bodies that cannot move, are left out. A step that is
/// cut into substeps stands with the last of them. Nothing as soon as `stop` turns true. Throws SceneError, InputError,
/// FileError.
std::vector<StoredStep> last_steps(const std::filesystem::path& scene, double until, const std::function<bool()>& stop);

}  // namespace nilas::compare
