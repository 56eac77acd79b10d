#pragma once
/// Points that several parts of a body share where their surfaces run on from one to the next.
#include <cstddef>
#include <vector>

#include "contact/detect/broad/contact_point.h"
#include "core/bodies/bodies.h"

namespace nilas {

/// The points from place `first` on are those of two bodies, from several pairs of parts. Of two pairs' points at the
/// same place, within `touching` [m], whose normals differ gently one stays, with the mean normal; and where surfaces
/// of several pairs lie in one plane their points are reduced as those of one pair are (keep_spread_points), since what
/// lies on the seam between them holds up nothing that the corners do not. The order of the points is kept.
void join_at_seams(const Bodies& bodies, double touching, double margin, std::size_t first,
                   std::vector<ContactPoint>& points);

}  // namespace nilas
