#pragma once
/// The hardest contact problem that a scene meets.
#include <filesystem>
#include <optional>

#include "contact/problem/problem.h"

namespace nilas::compare {

struct HardestStep {
  contact::ContactProblem problem;
  double time = 0;  ///< end of the step [s]
  int iterations = 0;
};

/// Runs a scene up to a time [s] on one thread and returns its hardest step. It is the one with most iterations of the
/// solver, and of these the one with most contacts. Steps with a contact between bodies that cannot move are left out,
/// because no file can hold them. Nothing if bodies never touch. Throws SceneError, InputError, FileError.
std::optional<HardestStep> hardest_step(const std::filesystem::path& scene, double until);

}  // namespace nilas::compare
