#pragma once
/// What a comparison of one scene needs to go on.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "apps/compare/scenes/plan/plan.h"

namespace nilas {

struct SceneStudy {
  std::filesystem::path scene;  ///< absolute
  std::string fingerprint;      ///< of the scene as asked
  Overrides overrides;          ///< the user's own
  Plan plan;
  bool ablation = false;
  std::string reference = "auto";  ///< or the run folder that errors are judged by
  bool event_driven = false;       ///< the reference integrates between events
  std::size_t probe_steps = 0;     ///< of the first setting, alone on the machine
  double probe_ms = 0;             ///< that they took
  double budget_s = 0;
  int jobs = 1;
  bool keep_runs = false;
  std::vector<Omission> refused;  ///< settings that the scene does not take
  std::vector<Omission> absent;   ///< simplifications that an ablation has nothing to turn on for

  std::uint64_t seed = 0;  ///< of the scene as asked
};

}  // namespace nilas
