#pragma once
/// Axes of pairs with parts that are pieces of larger bodies: what leads out of a part into its neighbour is no way
/// out.
#include "contact/detect/search/axis_search.h"

namespace nilas {

/// `axis` is the best of the two parts by themselves, within the margin, and room.facing holds the surfaces along it.
/// Where it does not lead out of both whole bodies it is replaced by the best of the faces, and of the crossing edges,
/// that do. Leaves in room.facing the points that the whole bodies show each other; false when there are none.
/// Ways from which a nearer one turns off are left to the pair of parts that has that one, unless `alone`: no other
/// pair of the two bodies has any.
bool find_way_out(const PairView& pair, AxisSearchRoom& room, Axis& axis, bool alone);

}  // namespace nilas
