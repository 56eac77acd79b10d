#pragma once
/// What runs of a comparison cost, measured on short runs and estimated for others.
#include <limits>
#include <vector>

#include "apps/compare/scenes/plan/setting.h"

namespace nilas {

/// What the first setting costs, measured on a short run of its own, and what is known of others.
struct CostModel {
  /// Processor time per simulated second from the stretch before it until a time.
  struct Stretch {
    double until = 0;   ///< since the start [s]
    double other = 0;   ///< beside the solver [s/s]
    double solver = 0;  ///< [s/s]
  };
  double setup_s = 0;  ///< reading, packing ice, writing [s]
  std::vector<Stretch> rate;
  double window_from = std::numeric_limits<double>::quiet_NaN();  ///< of the mean load; NaN: not known [s]
  /// A tolerance of the reference [m/s], and the time of a step's solve to it over the first setting's.
  struct Tightness {
    double tolerance = 0, weight = 1;
  };
  std::vector<Tightness> reference;  ///< as measured, the tightest first

  /// Of the steps of a run of the first setting over `length` simulated seconds, with a solver that takes `weight`
  /// times as long; beyond what was measured the last stretch goes on.
  double steps_seconds(double length, double weight = 1) const;
  /// Between what was measured by powers of the tolerance, beyond it as its nearest end; 1 of nothing.
  double reference_weight(double tolerance) const;
};

/// The loosest that judges settings whose tightest tolerance is `tolerance` [m/s]: a tenth.
double loosest_reference(double tolerance);

/// Tolerances of the reference whose cost is measured: `asked`, and the loosest that a plan may come to, where it is
/// not `fixed`. `own`: the scene's own setting.
std::vector<double> measured_tolerances(double asked, bool fixed, const CompareSetting& own);

/// What a solve of one setting takes over one of the first, by what solvers are known to take.
double solver_weight(const CompareSetting& setting, const CompareSetting& first);

}  // namespace nilas
