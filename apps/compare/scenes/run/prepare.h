#pragma once
/// Measures what runs of a scene cost, and plans a comparison by it.
#include <functional>
#include <string>

#include "apps/compare/scenes/plan/grid.h"
#include "apps/compare/scenes/run/scene_store.h"
#include "apps/compare/workshop/narrator.h"

namespace nilas {

/// What the user asks for beyond what SceneStudy holds.
struct PlanWishes {
  std::optional<int> realisations;
  double reference_tolerance = 0;          ///< [m/s]
  bool fixed_reference_tolerance = false;  ///< it is not loosened to fit the budget
  bool names_axes = false;                 ///< the user named solvers, laws, steps ...
  std::size_t core = 0;                    ///< settings of the grid that differ from the first in one thing
  double started_s = 0;                    ///< when the budget began, by steady_seconds()
};

/// Sets the plan of a study and what was measured for it: a twentieth of the budget for the first setting and as much
/// for the reference at two tolerances, half a minute each at most, and where it is cheap a whole run next to as many
/// others as there will be. Returns why the first setting made no step, or nothing. Throws InputError where the scene
/// cannot run.
std::string prepare(const Scene& scene, const Grid& grid, const PlanWishes& wishes, const SceneStore& store,
                    const Narrator& narrator, const std::function<bool()>& stop, SceneStudy& study);

}  // namespace nilas
