#pragma once
/// Measures the cost of runs of a scene and plans a comparison with it.
#include <functional>
#include <string>

#include "apps/compare/scenes/plan/grid.h"
#include "apps/compare/scenes/run/scene_store.h"
#include "apps/compare/workshop/narrator.h"

namespace nilas::compare {

/// The requests of the user that SceneStudy does not hold.
struct PlanWishes {
  std::optional<int> realisations;
  double reference_tolerance = 0;          ///< tolerance of the reference's solver [m/s]
  bool fixed_reference_tolerance = false;  ///< the tolerance is not loosened to fit the budget
  bool names_axes = false;                 ///< the user named solvers, laws, steps ...
  std::size_t core = 0;                    ///< number of the first settings that differ in at most one thing
  double started_s = 0;                    ///< start of the budget, on the clock of steady_seconds() [s]
};

/// Sets the plan of a study and the figures that were measured for it. The measurements take a twentieth of the budget
/// for the first setting and as much for the reference at two tolerances, at most 30 s each. If it is cheap, a whole
/// run is made next to as many others as there will be. Returns why the first setting made no step, or an empty text.
/// Throws InputError if the scene cannot run.
std::string prepare(const scene::Scene& scene, const Grid& grid, const PlanWishes& wishes, const SceneStore& store,
                    const Narrator& narrator, const std::function<bool()>& stop, SceneStudy& study);

}  // namespace nilas::compare
