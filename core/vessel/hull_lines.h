#pragma once
/// Waterlines of a generated hull, port side: convex polygons with the same edge directions at every height, so that the
/// solid between them is convex wherever the edges' offsets are concave in z.
#include <vector>

#include "core/base/math.h"
#include "core/vessel/hull.h"

namespace nilas {

/// One height's waterline, port side, from the transom's centre (y = 0) to the stem (y = 0).
using Waterline = std::vector<Vec2>;

/// How finely a form is cut.
struct HullFineness {
  int bow = 12, middle = 6, stern = 8;  ///< edges of the forebody, the parallel body and the run
  int bilge = 4, side = 8;              ///< rows below and above the bilge
};

/// Heights of the waterlines, keel to deck.
std::vector<double> waterline_heights(const HullForm& form, const HullFineness& fineness);
Waterline waterline(const HullForm& form, const HullFineness& fineness, double z);

/// Throws InputError naming the parameter, what was found and what is allowed.
void demand_sensible(const HullForm& form);

}  // namespace nilas
