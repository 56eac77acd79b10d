#pragma once
/// Finds axes of pairs with parts that are pieces of larger bodies. An axis that leads out of a part into its neighbour
/// does not serve.
#include "contact/detect/search/axis_search.h"

namespace nilas::detect {

/// Replaces `axis` where it does not lead out of both whole bodies. On entry it is the best axis of the two parts by
/// themselves, within the margin, and room.facing holds the surfaces along it. The replacement is the best of the
/// faces, and of the crossing edges, that do lead out. Leaves in room.facing the points that the whole bodies show each
/// other. Returns false when there are none.
/// An axis is left to another pair of parts where that pair has a shorter exit, unless `alone`: no other pair of the
/// two bodies has any.
bool find_way_out(const PairView& pair, AxisSearchRoom& room, Axis& axis, bool alone);

}  // namespace nilas::detect
