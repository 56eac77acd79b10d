#pragma once
/// Power diagram of weighted sites, and weights that give its cells required areas.
#include <vector>

#include "core/field/spec/loose_floe.h"

namespace nilas::field {

/// Sites p_i with weights w_i [m^2]: cell i holds the points x of the region with |x - p_i|^2 - w_i least.
struct PowerSites {
  std::vector<Vec2> points;     ///< [m]
  std::vector<double> weights;  ///< [m^2]; all alike: a Voronoi diagram
};

struct PowerCell {
  std::vector<Vec2> outline;  ///< convex, counter-clockwise; empty when the site's weight is too small [m]
  std::vector<int> beyond;    ///< site across the edge (k, k + 1); -1: the region's edge or an obstacle
  double area = 0;            ///< [m^2]
};
/// The cells. Next to an obstacle, a cell is cut at the edge of the obstacle from which its site is farthest. Cells do
/// not overlap; without obstacles they fill the region. Neighbours come from CGAL's regular triangulation.
std::vector<PowerCell> power_cells(const PowerSites& sites, const FieldBounds& bounds);

/// Moves the sites and sets the weights so that the cells' areas are in proportion to `shares` and sites are near the
/// centroids of their cells. Without obstacles the relative error is at most `tolerance`. Does `rounds` of Lloyd's
/// steps, each followed by a damped Newton iteration for the weights [Kitagawa, Merigot, Thibert 2019; de Goes et al.
/// 2012]. Returns the cells.
std::vector<PowerCell> cells_with_areas(PowerSites& sites, const std::vector<double>& shares, const FieldBounds& bounds,
                                        int rounds, double tolerance);

}  // namespace nilas::field
