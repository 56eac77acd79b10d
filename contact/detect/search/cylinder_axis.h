#pragma once
/// Finds the best axis of a cylinder with a polytope or another cylinder.
#include "contact/detect/search/axis_search.h"

namespace nilas::detect {

/// Works like find_axis, but remembers only whether there was an axis. Candidates: faces and caps, the perpendiculars
/// from the cylinder's axis and rims to the other part's supporting vertices and edges, and FCL's direction when the
/// best of them is not proven.
Axis find_cylinder_axis(const PairView& pair, const RememberedAxis& remembered, FclShapes& fcl, bool ask_first,
                        AxisSearchRoom& room, AxisSearchCounts& counts);

}  // namespace nilas::detect
