#pragma once
/// Bending failure of ice wedges between radial cracks: load, and distance of the circumferential crack.
#include "fracture/bend/wedge_series.h"
#include "fracture/split/tabulate.h"

namespace nilas::fracture {

/// A narrow wedge on water, as in Nevel (1958): an endless beam of the width b0 x, with b0 = 2 tan(alpha / 2) for the
/// opening angle alpha. Its tip is free. A total force P acts over 0 < x < a:
///     (E h^3 / 12) (b0 x w'')'' + k b0 x w = q(x),    sigma = 6 M / (b0 x h^2),    l^4 = E h^3 / (12 k).
/// The constructor tabulates the exact series (wedge_series.h) over (a/l)^(1/3), in which all three functions are
/// smooth. They are then cheap and twice continuously differentiable. They are within 1e-6 of the series, relative
/// (x_max: in l), for 0 <= a/l <= k_longest_tip_load. Longer loads count as that long. Throws ContractError for
/// negative lengths.
class WedgeTable {
 public:
  explicit WedgeTable(TipLoad load);

  /// The factor 6 P / (b0 sigma h^2), where sigma is the largest bending stress. It is 1 at a = 0. For a pressure it is
  /// within 1.2 % of 1.05 + 2 a/l + 0.5 (a/l)^3 for a/l from 0.02 to 0.7.
  double load_factor(double a_over_l) const;
  /// The ratio x_max / l, where x_max is the distance of the largest stress from the tip.
  double breaking_length(double a_over_l) const;
  /// The deflection w k b0 l^2 / P of the tip.
  double tip_deflection(double a_over_l) const;

 private:
  TableSpline load_factor_, breaking_length_, tip_deflection_;
};

/// The force [N] on the tip at which one wedge of the opening angle `angle` [rad] breaks. a_over_l is the loaded length
/// over the beam's characteristic length. The width b0 x is that of a narrow wedge, good up to about 60 degrees. Throws
/// ContractError unless 0 < angle < pi and thickness [m] and flexural_strength [Pa] are positive.
double wedge_failure_load(const WedgeTable& table, double a_over_l, double angle, double thickness,
                          double flexural_strength);
/// The force [N] that breaks `count` such wedges at once, which share it evenly.
double wedges_failure_load(const WedgeTable& table, double a_over_l, double angle, int count, double thickness,
                           double flexural_strength);

/// The rule of the breaking radius at the speed v at which the ice is pushed down, since water resists that motion:
/// R = R_static max(1 + slope v, least). A breaking length from the speed is due to Wang (2001), whose method Su et al.
/// (2010) extended (Zhou and Peng 2013). No value of `slope` could be checked against these papers. The default 0 and
/// the lower limit, without which R turns negative, are choices of this program.
struct SpeedRule {
  double slope = 0;     ///< C_v [s/m]; 0 switches the rule off.
  double least = 0.25;  ///< Least R over R_static [-].
};
/// The radius [m] of the circumferential crack about the loaded tip: x_max for the beam's characteristic length l [m],
/// after the speed rule for `speed` >= 0 [m/s].
double bending_radius(const WedgeTable& table, double a_over_l, double l, double speed = 0, const SpeedRule& rule = {});

}  // namespace nilas::fracture
