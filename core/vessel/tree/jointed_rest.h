#pragma once
/// The rest of a towed vessel with parts: weight, buoyancy, cells and the springs of its joints are in balance.
#include <optional>

#include "core/vessel/tree/jointed_tree.h"

namespace nilas::vessel {

struct JointedRest {
  VecX coordinates;           ///< coordinates of the tree
  std::optional<int> moving;  ///< empty at rest; else the body that moves: 0 the hull, k + 1 part k
  Wrench carried;             ///< the carriage's load there, about its own point, frame G
};

/// Searches the rest. `tree` belongs to `model`, which has a carriage. It stands at `carriage` with its coordinates as
/// placed; its coordinates afterwards are undefined. The balance is sought along coordinates that cells and springs
/// hold, along free heave, roll and pitch of a hull that is afloat, and along coordinates of parts without a spring
/// that weight and water restore. Other coordinates stay as placed. There is no rest where one of these carries more
/// than 1 % of the weight, where a spring is too weak to hold its part there, or where a part starts with a rate. Parts
/// that no joint holds are left out. Throws InputError when no balance is found.
JointedRest jointed_rest(JointedTree& tree, const VesselModel& model, const RestModel& rest,
                         const CarriageMotion::State& carriage);

}  // namespace nilas::vessel
