#pragma once
/// One point of a comparison's grid: how the contacts of a scene are solved and its motion is stepped.
#include <string>
#include <vector>

#include "apps/compare/scenes/plan/simplification.h"
#include "core/choices/defaults.h"

namespace nilas::compare {

/// The tolerance that stands in for a fixed number of sweeps [m/s].
constexpr double k_usual_tolerance = defaults::k_tolerance;

struct CompareSetting {
  std::string solver, law, integrator, stabilisation;
  double step = 0;       ///< time step [s]
  double tolerance = 0;  ///< tolerance on law_map_m_s [m/s]; 0: always the scene's number of sweeps
  std::vector<Simplification> simplifications{};
  scene::Overrides more{};  ///< other changes of the scene

  /// The overrides as `--set` takes them. The last one for a path applies.
  scene::Overrides overrides() const;
  bool operator==(const CompareSetting&) const = default;
};

/// The setting that the scene asks for.
CompareSetting setting_of(const scene::Scene& scene);
/// The setting in which each simplification that has an effect on the scene is taken out. Its overrides are for
/// `scene`.
CompareSetting without_simplifications(const scene::Scene& scene);
/// The same with some simplifications turned on, singly or together.
CompareSetting with_simplifications(const scene::Scene& scene, const std::vector<Simplification>& on);

/// The label of a setting: its differences from the first setting of the comparison, as in "nsgs + step 0.02 s", or
/// "own setting" without any. In an ablation it is the name of the simplification, "all together" or "none".
std::string label_of(const CompareSetting& setting, const CompareSetting& first);
/// The label with all axes: "auto, coulomb, step 0.01 s, tolerance 1e-4 m/s, projection, moreau".
std::string full_label(const CompareSetting& setting);
/// The label that a setting would have with the first setting's step. Settings that differ in the step alone share it.
std::string label_without_step(CompareSetting setting, const CompareSetting& first);
/// The simplifications of a setting as tables name them: "pyramid;50 sweeps".
std::string simplifications_text(const CompareSetting& setting);
/// The names of the axes on which two settings differ, in the order solver, law, step, tolerance, stabilisation,
/// integrator.
std::vector<std::string> differences(const CompareSetting& a, const CompareSetting& b);

/// Whether `part` has some of the changes that `whole` has from `first`, at least one and not all of them.
bool is_part(const CompareSetting& part, const CompareSetting& whole, const CompareSetting& first);

/// The coarsest step of the settings [s].
double coarsest_step(const std::vector<CompareSetting>& settings);

}  // namespace nilas::compare
