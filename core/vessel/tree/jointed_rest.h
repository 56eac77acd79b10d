#pragma once
/// Where a towed vessel with parts is at rest: weight, buoyancy, cells and the springs of its joints balance.
#include <optional>

#include "core/vessel/tree/jointed_tree.h"

namespace nilas {

struct JointedRest {
  VecX coordinates;           ///< of the tree
  std::optional<int> moving;  ///< nothing where it rests; else the body that moves: 0 the hull, k + 1 part k
  Wrench carried;             ///< what the carriage carries there, about its own point in G
};

/// `tree`: of `model`, which has a carriage; it stands at `carriage` with its coordinates as placed, and is left
/// anywhere. Along these the balance is found: what cells and springs hold, heave, roll and pitch of a hull that are
/// free where it is afloat, and what weight and water bring back of parts without a spring. Other coordinates stay as
/// placed. More than 1 % of the weight along one of these is no rest, and no rest is a part that hangs on a spring too
/// weak to hold it there, or one that starts with a rate. Parts that no joint holds are left out. Throws InputError
/// when no balance is found.
JointedRest jointed_rest(JointedTree& tree, const VesselModel& model, const RestModel& rest,
                         const CarriageMotion::State& carriage);

}  // namespace nilas
