#pragma once
/// Which steps are solved a second time, to see how far the ice load of one step is off: docs/theory/load-error.md.
#include <memory>

#include "contact/solvers/solver.h"
#include "core/scene/scene.h"

namespace nilas::sim {

struct WorldParts;

struct LoadChecks {
  std::unique_ptr<solvers::ContactSolver> solver;  ///< solves to `tolerance`; empty where no load is checked
  double tolerance = 0;                            ///< [m/s]
  long every = 0;                                  ///< one of so many steps is checked

  /// Whether the load of the step with this number, from 1, is checked. Checks stand in the middle of their stretches.
  bool is_due(long step) const { return solver && step % every == every / 2; }
};

/// As many checks as the scene asks for, or those of its default. None without ice or without a body that bears
/// loads: the vessel or a fixed one. The integrator `reference` and perturbed runs have none.
LoadChecks build_load_checks(const scene::Scene& scene, const WorldParts& parts, int threads);

}  // namespace nilas::sim
