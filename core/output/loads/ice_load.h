#pragma once
/// The ice load on a vessel or a structure over the window of a run: mean, scatter and peaks along and across the
/// course. Also the force of the towing carriage. docs/theory/load-error.md
#include <optional>
#include <string>
#include <vector>

#include "core/output/loads/half_means.h"
#include "core/output/loads/load_error.h"
#include "core/output/loads/load_statistics.h"
#include "core/output/loads/load_window.h"
#include "core/output/loads/peak.h"
#include "core/output/loads/step_dependence.h"

namespace nilas::output {

/// One component of a load over a window.
struct ComponentLoad {
  LoadStatistics statistics;
  Peak peak;
  std::optional<double> half_width;  ///< half width of the mean's error for about 95 % of runs; empty: not known [N]
  std::optional<HalfMeans> halves;   ///< means over the halves of the window; empty: too few steps
};

/// The mean force of the carriage along the course, positive forward, and its components: tow = ice + others + water +
/// modules + inertia. With rods, their pull is part of `inertia`, and outputs state this.
struct TowForce {
  double mean = 0, std = 0;                ///< [N]
  double ice = 0, water = 0, inertia = 0;  ///< [N]
  bool on_rods = false;
  std::vector<std::pair<std::string, double>>
      modules;                       ///< names and resistances of other load modules on the vessel [N]
  double others = 0;                 ///< force of contacts with walls and bodies [N]
  double speed = 0;                  ///< mean speed along the course over the window [m/s]
  std::optional<double> open_water;  ///< mean force of the same tow without ice [N]
  std::string open_water_source;     ///< source of open_water, in words
  double net() const {
    return mean - open_water.value_or(0);
  }  ///< without open-water force, as towing basins report it [N]
};

struct IceLoad {
  LoadWindow window;
  double filter = 0;       ///< averaging time of filtered peaks [s]
  double step = 0;         ///< [s]
  bool touched = false;    ///< true if ice pressed on it at least once; for a vessel, within the window
  bool rigid = true;       ///< true if some ice meets the hull as a rigid body
  bool elastic = false;    ///< true if some contacts of the scene are elastic
  ComponentLoad along;     ///< positive astern
  ComponentLoad across;    ///< positive to port
  double in_largest = 0;   ///< share of the impulse along the course in 1 % of the steps
  StepDependence on_step;  ///< of the load along the course
  std::optional<TowForce> tow;

  /// Whether the raw peak along the course is an impact of at most two steps, of more than twice the mean, that nothing
  /// but the step limits. Such a peak is the impulse over the step.
  bool peak_is_impulse_over_step() const;
  /// Whether rigid impacts in single steps contribute so much to the mean that the ice's strength should limit them.
  bool impacts_dominate() const;
};

/// The load of one component from its values in steps of `h` [s], the first of which begins at t0 [s]. `ice_broke`:
/// ice broke before the end of the last, so the load has a long memory.
ComponentLoad component_load(const std::vector<double>& part, double t0, double h, double filter,
                             bool ice_broke = false);

/// A body that the scene holds fixed.
struct StructureLoad {
  std::string name;
  IceLoad ice;                                               ///< has no tow force
  std::vector<std::pair<std::string, ComponentLoad>> loads;  ///< loads by column name, without the structure's name
};

}  // namespace nilas::output
