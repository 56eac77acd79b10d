#pragma once
/// Bending failure of ice wedges between radial cracks: load, and distance of the circumferential crack.
#include "fracture/bend/wedge_series.h"
#include "fracture/split/tabulate.h"

namespace nilas {

/// Nevel's narrow wedge (Nevel 1961; Kerr 1975): a beam of width b0 x, b0 = 2 tan(alpha / 2) for the opening angle
/// alpha, on water, endless, its tip free and loaded over 0 < x < a by a total force P:
///     (E h^3 / 12) (b0 x w'')'' + k b0 x w = q(x),    sigma = 6 M / (b0 x h^2),    l^4 = E h^3 / (12 k).
/// Tables of the exact series (wedge_series.h) over (a/l)^(1/3), in which all three are smooth; built once, then cheap
/// and twice continuously differentiable. Within 1e-6 of the series, relative (x_max: of l) for
/// 0 <= a/l <= k_longest_tip_load; longer loads count as that long, negative ones throw ContractError.
class WedgeTable {
 public:
  explicit WedgeTable(TipLoad load);

  /// 6 P / (b0 sigma h^2), sigma the largest bending stress. 1 at a = 0; about 1.05 + 2 a/l + 0.5 (a/l)^3 for a
  /// pressure (Nevel, as Kerr quotes him).
  double load_factor(double a_over_l) const;
  /// x_max / l, distance of the largest stress from the tip.
  double breaking_length(double a_over_l) const;
  /// w k b0 l^2 / P at the tip.
  double tip_deflection(double a_over_l) const;

 private:
  TableSpline load_factor_, breaking_length_, tip_deflection_;
};

/// Force [N] on the tip of one wedge of opening angle `angle` [rad], 0 < angle < pi, at which it breaks; a_over_l is
/// the loaded length over the beam's characteristic length. Widths b0 x are those of a narrow wedge: good to some
/// 60 degrees. Throws ContractError unless thickness [m] and flexural_strength [Pa] are positive.
double wedge_failure_load(const WedgeTable& table, double a_over_l, double angle, double thickness,
                          double flexural_strength);
/// Force [N] that breaks `count` such wedges at once, which share it evenly.
double wedges_failure_load(const WedgeTable& table, double a_over_l, double angle, int count, double thickness,
                           double flexural_strength);

/// How the breaking radius shrinks with the speed at which the ice is pushed down, as the water's inertia holds it up:
/// R = R_static (1 + slope v) (Wang 2001; Su, Riska & Moan 2010, with slope -0.14 s/m for Tor Viking), at least
/// `least` of R_static; the lower limit is ours, as the line turns negative at 7 m/s.
struct SpeedRule {
  double slope = 0;     ///< C_v [s/m]; 0: static
  double least = 0.25;  ///< of R_static
};
/// Radius [m] of the circumferential crack about the loaded tip: x_max of the beam's characteristic length l [m], and
/// the speed rule for `speed` >= 0 [m/s].
double bending_radius(const WedgeTable& table, double a_over_l, double l, double speed = 0, const SpeedRule& rule = {});

}  // namespace nilas
