#pragma once
/// The hardest contact problem that a scene meets.
#include <filesystem>
#include <optional>

#include "contact/problem/problem.h"

namespace nilas {

struct HardestStep {
  ContactProblem problem;
  double time = 0;  ///< at the step's end [s]
  int iterations = 0;
};

/// Runs a scene up to a time [s] on one thread. The hardest step is the one whose solver took most iterations, of these
/// the one with most contacts; steps with contacts that nothing can move are left out, since no file can hold them.
/// Nothing where bodies never touch. Throws SceneError, InputError, FileError.
std::optional<HardestStep> hardest_step(const std::filesystem::path& scene, double until);

}  // namespace nilas
