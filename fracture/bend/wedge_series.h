#pragma once
/// Nevel's narrow infinite wedge on an elastic foundation, solved by its power series.
#include <vector>

namespace nilas {

/// How the load lies on the first stretch 0 < x < a of the wedge: as an even pressure on its area, so that the force
/// per length grows with x, or as an even force per length.
enum class TipLoad { pressure, line };

/// Lengths in l, loads in P (`wedge.h`).
struct WedgeResponse {
  double curvature = 0;       ///< largest w'' of w k b0 l^2 / P: sigma b0 h^2 / (6 P)
  double x_max = 0;           ///< where, from the tip
  double tip_deflection = 0;  ///< w k b0 l^2 / P at the tip
};

/// Longest load that is treated, a / l. Under longer ones the largest curvature of a line load jumps from behind the
/// load to below it, and the tip is no longer what breaks.
constexpr double k_longest_tip_load = 2;

/// (x w'')'' + x w = q, free tip, bounded at infinity. Series about the tip of the exponents 0, 1 (twice, one with a
/// logarithm), 2 and of the particular solution; joined at x = a; the solutions that grow are removed by w = w' = 0 at
/// x = 20, which alters w at x by exp(-sqrt(2) (20 - x)). Deflection and curvature are exact to 1e-9 of their largest
/// values, x_max to 1e-8. 0 <= a <= k_longest_tip_load, else ContractError; a = 0 is a point load at the tip.
WedgeResponse solve_wedge(TipLoad load, double a);

/// Curvatures w'' at the places `at` > 0 [of x_max], over the largest. 0 < a <= k_longest_tip_load, else ContractError.
std::vector<double> wedge_curvatures(TipLoad load, double a, const std::vector<double>& at);

}  // namespace nilas
