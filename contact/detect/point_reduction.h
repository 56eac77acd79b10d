#pragma once
/// At most four well-spread points for one pair of parts.
#include <vector>

#include "contact/detect/overlay.h"

namespace nilas {

constexpr int k_most_points = 4;

/// Keeps the deepest point and the three that span the largest quadrilateral with it, its area weighted by how near the
/// points' gaps are to the deepest against `margin` [m] (all gaps are below it): a floe that lies on a blunt ridge
/// keeps both ends of it, instead of rocking between them.
///
/// Where the points are their own image in t1, as where a ship meets a floe on its centre line, so is the set kept.
/// Ties, within `tolerance` [m], are broken by geometry alone: the mean nearest to the mean of all, then the set that
/// is its own image in t2, then the one longest along t1, then the one farther ahead on it. So a mirrored contact keeps
/// the mirrored points.
void keep_spread_points(double tolerance, double margin, std::vector<OverlayPoint>& points);

}  // namespace nilas
