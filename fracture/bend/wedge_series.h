#pragma once
/// The narrow infinite wedge on an elastic foundation (Nevel 1958), solved by its power series.
#include <vector>

namespace nilas::fracture {

/// The distribution of the load on 0 < x < a of the wedge. `pressure` is an even pressure on the area, whose force per
/// length grows with x. `line` is an even force per length.
enum class TipLoad { pressure, line };

/// The response of a wedge to its load. Lengths are in l, loads in P (`wedge.h`).
struct WedgeResponse {
  double curvature = 0;       ///< Largest w'' of w k b0 l^2 / P, which is sigma b0 h^2 / (6 P).
  double x_max = 0;           ///< Its distance from the tip.
  double tip_deflection = 0;  ///< w k b0 l^2 / P at the tip.
};

/// The longest load a / l that is treated. Under longer ones the largest curvature of a line load jumps from behind the
/// load to below it, so that the break is no longer behind a loaded tip.
constexpr double k_longest_tip_load = 2;

/// Solves (x w'')'' + x w = q with a free tip and w bounded at infinity. The power series about the tip have the
/// exponents 0, 1 (twice, once with a logarithm) and 2; a particular solution is added. They are joined at x = a. The
/// growing solutions are removed by w = w' = 0 at x = 20, which alters w at x by exp(-sqrt(2) (20 - x)). Deflection and
/// curvature are exact to 1e-9 of their largest values, x_max to 1e-8. a = 0 is a point load at the tip. Throws
/// ContractError unless 0 <= a <= k_longest_tip_load.
WedgeResponse solve_wedge(TipLoad load, double a);

/// The curvatures w'' over the largest one, at the places `at` > 0 in units of x_max. Throws ContractError unless
/// 0 < a <= k_longest_tip_load.
std::vector<double> wedge_curvatures(TipLoad load, double a, const std::vector<double>& at);

}  // namespace nilas::fracture
