#pragma once
/// The motion before the impulses: none with semi-implicit Euler, the share 1 - theta of the substep with moreau.
#include <optional>
#include <vector>

#include "core/sim/account/ledger.h"
#include "core/sim/step/vessel_step.h"
#include "core/sim/world/world_state.h"

namespace nilas {

/// Bodies and energies before that motion.
struct BeforeMotion {
  std::vector<Vec3> p, v, w;
  std::vector<Quat> q;
  std::vector<Mat3> R;
  EnergyAccount energy;
};

struct SubstepStart {
  double h = 0;                         ///< the longest that the substep may be [s]
  VesselStart vessel;                   ///< of a vessel that is booked whole
  std::optional<BeforeMotion> to_undo;  ///< where bodies moved, or modules remember what a search changes
};

/// Moves everything to the pose where the impulses of a substep of at most `longest` [s] act; of less where bodies
/// would pass through each other on the way. Throws SimulationError where they do however short the substep is.
SubstepStart begin_substep(World& world, double t, double longest);

/// Goes back to where begin_substep() found the world.
void take_back(World& world, const SubstepStart& start);

}  // namespace nilas
