#pragma once
/// Which settings a comparison runs, in the order of what they tell.
#include <string>
#include <vector>

#include "apps/compare/scenes/plan/setting.h"

namespace nilas {

/// What the command line asks for; empty lists leave an axis to the default grid.
struct GridRequest {
  std::vector<std::string> solvers, laws, integrators, stabilisations;
  std::vector<double> steps, tolerances;
  bool ablate = false;

  /// Whether any axis is named.
  bool names_axes() const;
};

/// A setting that cannot run, and why.
struct RefusedSetting {
  CompareSetting setting;
  std::string reason;
};

/// The scene's own setting first (with `ablate` alone: the one without any simplification), then those that differ from
/// it on one axis, then on two and more: what comes last tells least.
struct Grid {
  std::vector<CompareSetting> settings;
  std::vector<RefusedSetting> refused;
};

/// Throws InputError (nearest name) for a solver, law, integrator or stabilisation that does not exist, and where
/// nothing is left beside the scene's own setting. `overrides`: the user's own, under which the scene was read.
Grid make_grid(const Scene& scene, const Overrides& overrides, const GridRequest& request);

/// How many settings differ from the first in one thing, which come first; all of an ablation.
std::size_t core_of(const Grid& grid, const GridRequest& request);

/// The setting by which errors are judged. Few free bodies, without a field of ice and without floes before a towed
/// vessel: the event-driven integrator `reference`, which `nilas verify` holds against closed forms. Else half the
/// finest step of the grid, exact Coulomb friction (no friction where the scene has none), projection, moreau where the
/// scene takes it, the reference solver at `tolerance`.
CompareSetting reference_setting(const Scene& scene, const Overrides& overrides, const Grid& grid, double tolerance);

/// Reads the scene with a setting. Throws SceneError or InputError where it cannot run.
Scene read_with(const Scene& scene, const Overrides& overrides, const CompareSetting& setting);

}  // namespace nilas
