#pragma once
/// The settings that a comparison runs, the most informative first.
#include <string>
#include <vector>

#include "apps/compare/scenes/plan/setting.h"

namespace nilas::compare {

/// The request of the command line. An empty list leaves an axis to the default grid.
struct GridRequest {
  std::vector<std::string> solvers, laws, integrators, stabilisations;
  std::vector<double> steps, tolerances;
  bool ablate = false;

  /// Whether any axis is named.
  bool names_axes() const;
};

/// A setting that cannot run, and the reason.
struct RefusedSetting {
  CompareSetting setting;
  std::string reason;
};

/// The settings, the least informative last. The first is the scene's own, or with `ablate` the one without any
/// simplification. Settings that differ from it on one axis follow, then those that differ on two and more.
struct Grid {
  std::vector<CompareSetting> settings;
  std::vector<RefusedSetting> refused;
};

/// Makes the grid. `overrides`: the user's, with which the scene was read. Throws InputError with the nearest name for
/// a solver, law, integrator or stabilisation that does not exist, and if only the scene's own setting is left.
Grid make_grid(const scene::Scene& scene, const scene::Overrides& overrides, const GridRequest& request);

/// The number of settings, from the first on, that differ from it in at most one thing; all settings of an ablation.
std::size_t core_of(const Grid& grid, const GridRequest& request);

/// The setting by which errors are judged. For few free bodies, without a vessel in a field of ice or towed into floes,
/// it has the event-driven integrator `reference`, which `nilas verify` checks against closed forms. Else it has half
/// the finest step of the grid, exact Coulomb friction (no friction if the scene has none), projection, moreau if the
/// scene takes it, and the solver auto at `tolerance` [m/s].
CompareSetting reference_setting(const scene::Scene& scene, const scene::Overrides& overrides, const Grid& grid,
                                 double tolerance);

/// Reads the scene with a setting. Throws SceneError or InputError if it cannot run.
scene::Scene read_with(const scene::Scene& scene, const scene::Overrides& overrides, const CompareSetting& setting);

}  // namespace nilas::compare
