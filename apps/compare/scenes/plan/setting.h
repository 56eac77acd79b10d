#pragma once
/// One point of a comparison's grid: how a scene is solved and stepped.
#include <string>
#include <vector>

#include "apps/compare/scenes/plan/simplification.h"

namespace nilas {

struct CompareSetting {
  std::string solver, law, integrator, stabilisation;
  double step = 0;       ///< [s]
  double tolerance = 0;  ///< on law_map_m_s; 0: always the scene's number of sweeps [m/s]
  std::vector<Simplification> simplifications{};
  Overrides more{};  ///< what else it changes of the scene

  /// As `--set` takes them, in an order in which the last wins.
  Overrides overrides() const;
  bool operator==(const CompareSetting&) const = default;
};

/// What the scene asks for.
CompareSetting setting_of(const Scene& scene);
/// The scene with every simplification taken out that it has anything of; `scene` must be what the overrides are for.
CompareSetting without_simplifications(const Scene& scene);
/// With some turned on, singly or together.
CompareSetting with_simplifications(const Scene& scene, const std::vector<Simplification>& on);

/// By what it differs from the first setting of its comparison: "nsgs + step 0.02 s"; "own setting" where in nothing.
/// Of an ablation the names of the simplifications.
std::string label_of(const CompareSetting& setting, const CompareSetting& first);
/// "auto, coulomb, step 0.01 s, tolerance 1e-4 m/s, projection, moreau".
std::string full_label(const CompareSetting& setting);
/// Its simplifications as tables name them: "pyramid;50 sweeps".
std::string simplifications_text(const CompareSetting& setting);
/// Names of the axes on which two settings differ, in the order solver, law, step, tolerance, stabilisation,
/// integrator.
std::vector<std::string> differences(const CompareSetting& a, const CompareSetting& b);

}  // namespace nilas
