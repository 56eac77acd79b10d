#pragma once
/// Waterlines of a generated hull, port side. The solid at height z is
///   { (x, y) : n_i . (x, y) <= h_i(z) for all i },
/// with the same edge normals n_i at every height: it is convex where every h_i is concave in z, and its faces are
/// plane trapezoids. To that end
///   the half breadth b(z) = beam/2 + (z - draught) tan(flare) - (loss in the bilge, a quarter circle) is concave;
///   the forebody is that of the design waterline, shrunk by b(z) / b(draught) about a stem that leans straight;
///   the run is shrunk likewise about a transom that leans straight;
///   between them lies a parallel body.
/// A wedge has the same b, stem and transom at all heights and no run.
#include <vector>

#include "core/base/math.h"
#include "core/hull/hull.h"

namespace nilas::hull {

/// One height's waterline, port side, from the transom's centre (y = 0) to the stem (y = 0).
using Waterline = std::vector<Vec2>;

/// How finely a form is cut. A wedge has no run and no bilge.
struct HullFineness {
  int bow = 12, middle = 6, stern = 8;  ///< edges of the forebody, the parallel body and the run
  int bilge = 4, side = 8;              ///< rows within and above the bilge
};

/// Heights of the waterlines, keel to deck.
std::vector<double> waterline_heights(const HullForm& form, const HullFineness& fineness);
/// The waterline at height z above the keel [m].
Waterline waterline(const HullForm& form, const HullFineness& fineness, double z);

/// Throws InputError naming the parameter, what was found and what is allowed.
void demand_sensible(const HullForm& form);

}  // namespace nilas::hull
