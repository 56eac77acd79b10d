#pragma once
/// A comparison of one scene, with all that it needs to be resumed.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "apps/compare/scenes/plan/plan.h"

namespace nilas::compare {

struct SceneStudy {
  std::filesystem::path scene;  ///< absolute path of the scene file
  std::string fingerprint;      ///< fingerprint of the scene with the user's overrides
  scene::Overrides overrides;   ///< the user's overrides
  Plan plan;
  bool ablation = false;
  std::string reference = "auto";  ///< "auto" or the run folder by which errors are judged
  bool event_driven = false;       ///< the reference integrates between events
  std::size_t probe_steps = 0;     ///< steps that the first setting made alone on the machine
  double probe_ms = 0;             ///< their time [ms]
  double budget_s = 0;
  int jobs = 1;
  bool keep_runs = false;
  std::vector<Omission> refused;  ///< settings that the scene does not take
  std::vector<Omission> absent;   ///< simplifications that have no effect on the scene of an ablation

  std::uint64_t seed = 0;  ///< seed of the scene with the user's overrides
};

}  // namespace nilas::compare
