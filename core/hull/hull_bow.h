#pragma once
/// The forebody's waterline of a generated hull: from the parallel side to the entrance angle at the stem.
#include <vector>

#include "core/hull/hull.h"

namespace nilas::hull {

/// Fullness of the bow: half the beam divided by the drop of a straight bow of this length and entrance angle. 1 is a
/// wedge; small values are full shoulders behind a blunt entrance; above 1 the bow is too short for the angle.
double bow_fullness(const HullForm& form);

/// A point of the forebody's waterline, from the shoulder (t = 0) to the stem (t = 1).
struct BowPoint {
  double t;     ///< share of the bow length
  double drop;  ///< distance from the parallel side, over bow length times slope at the stem
};

/// Points from the shoulder to the stem, one more than edges; the last edge has exactly the entrance angle. The bow of
/// a wedge is straight. Otherwise fullness of at least 0.5 gives a parabola that runs into a straight entrance; less
/// gives drop = t^p / p with p = 1 / fullness.
std::vector<BowPoint> bow_points(const HullForm& form, int edges);

}  // namespace nilas::hull
