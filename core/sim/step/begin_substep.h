#pragma once
/// The motion before the impulses: none with semi-implicit Euler, the share 1 - theta of the substep with Moreau.
#include <optional>
#include <vector>

#include "core/sim/account/ledger.h"
#include "core/sim/step/vessel_step.h"
#include "core/sim/world/world_state.h"

namespace nilas::sim {

/// Bodies and energies before that motion.
struct BeforeMotion {
  std::vector<Vec3> p, v, w;
  std::vector<Quat> q;
  std::vector<Mat3> R;
  EnergyAccount energy;
};

struct SubstepStart {
  double h = 0;                         ///< longest permitted length of the substep [s]
  VesselStart vessel;                   ///< filled for a vessel that is booked whole
  std::optional<BeforeMotion> to_undo;  ///< if bodies moved, or modules keep state that a search changes
};

/// Moves everything to the pose where the impulses of a substep of at most `longest` [s] act. The substep is shorter
/// where bodies would otherwise pass through each other on the way. Throws SimulationError where they do so however
/// short it is.
SubstepStart begin_substep(World& world, double t, double longest);

/// Restores the world that begin_substep() found.
void take_back(World& world, const SubstepStart& start);

}  // namespace nilas::sim
