#pragma once
/// Joins points that several parts of a body share where their surfaces continue from one to the next.
#include <cstddef>
#include <vector>

#include "contact/detect/broad/contact_point.h"
#include "core/bodies/bodies.h"

namespace nilas::detect {

/// Joins the points of two bodies from index `first` on, which come from several pairs of parts. Points of two pairs at
/// the same place, within `touching` [m], whose normals differ gently become one with the mean normal. Where surfaces
/// of several pairs lie in one plane, their points are reduced like those of one pair (keep_spread_points). The reason
/// is that points on the seam hold up nothing that the corners do not. The order of the points is kept.
void join_at_seams(const bodies::Bodies& bodies, double touching, double margin, std::size_t first,
                   std::vector<ContactPoint>& points);

}  // namespace nilas::detect
