#pragma once
/// The cost of the runs of a comparison, measured on short runs and estimated for others.
#include <limits>
#include <vector>

#include "apps/compare/scenes/plan/setting.h"

namespace nilas::compare {

/// The cost of the first setting, measured on a short run of its own, and what is known of others.
struct CostModel {
  /// Processor time per simulated second, from the end of the previous stretch to a time.
  struct Stretch {
    double until = 0;   ///< end of the stretch, from the start of the run [s]
    double other = 0;   ///< time of everything but the solver [s/s]
    double solver = 0;  ///< time of the solver [s/s]
  };
  double setup_s = 0;  ///< time of reading, packing ice and starting [s]
  std::vector<Stretch> rate;
  double window_from =
      std::numeric_limits<double>::quiet_NaN();  ///< start of the mean load's window [s]; NaN: not known
  /// A tolerance of the reference [m/s], and the ratio of the time of a step's solve to it to the first setting's.
  struct Tightness {
    double tolerance = 0, weight = 1;
  };
  std::vector<Tightness> reference;  ///< the measured ones, the tightest first

  /// The processor time [s] of the steps of a run of the first setting over `length` simulated seconds, with a solver
  /// that takes `weight` times as long. Beyond what was measured, the last stretch is taken to continue.
  double steps_seconds(double length, double weight = 1) const;
  /// The weight of a tolerance of the reference [m/s]. It follows a power law between measured tolerances, and is that
  /// of the nearest one outside of them; 1 if none was measured.
  double reference_weight(double tolerance) const;
};

/// The loosest tolerance of a reference for settings whose tightest tolerance is `tolerance` [m/s]: a tenth of it.
double loosest_reference(double tolerance);

/// The tolerances of the reference whose cost is measured [m/s]: `asked` and, unless it is `fixed`, the loosest that a
/// plan may choose. `own`: the scene's own setting.
std::vector<double> measured_tolerances(double asked, bool fixed, const CompareSetting& own);

/// The ratio of the time of a solve of one setting to one of the first, from what solvers are known to take.
double solver_weight(const CompareSetting& setting, const CompareSetting& first);

}  // namespace nilas::compare
