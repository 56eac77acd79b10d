#pragma once
/// The load of the ice on a vessel or a structure over the window of a run: its mean, scatter and peaks along and
/// across the course, and beside it the force of the towing carriage. docs/theory/load-error.md
#include <optional>
#include <string>
#include <vector>

#include "core/output/loads/load_error.h"
#include "core/output/loads/load_statistics.h"
#include "core/output/loads/load_window.h"
#include "core/output/loads/peak.h"

namespace nilas {

/// One component of a load over a window.
struct ComponentLoad {
  LoadStatistics statistics;
  Peak peak;
  std::optional<double> half_width;  ///< of the mean, for about 95 % of runs; nothing: not known [N]
};

/// The mean force of the carriage along the course, positive forward, and what takes it: tow = ice + others +
/// water + inertia. With rods their pull is within `inertia`, and outputs say so.
struct TowForce {
  double mean = 0, std = 0;                ///< [N]
  double ice = 0, water = 0, inertia = 0;  ///< [N]
  bool on_rods = false;
  double others = 0;                                            ///< contacts with walls and bodies [N]
  double speed = 0;                                             ///< mean speed along the course over the window [m/s]
  std::optional<double> open_water;                             ///< mean force of the same tow without ice [N]
  std::string open_water_source;                                ///< where that comes from, in words
  double net() const { return mean - open_water.value_or(0); }  ///< as a basin deducts it [N]
};

struct IceLoad {
  LoadWindow window;
  double filter = 0;      ///< averaging time of filtered peaks [s]
  double step = 0;        ///< [s]
  bool touched = false;   ///< ice pressed on it at least once, of a vessel within the window
  bool rigid = true;      ///< some ice meets the hull as a rigid body
  ComponentLoad along;    ///< positive astern
  ComponentLoad across;   ///< positive to port
  double in_largest = 0;  ///< part of the load's impulse along the course that 1 % of the steps carry
  std::optional<TowForce> tow;

  /// Whether rigid impacts of single steps make up so much of the mean that their size should be limited by the ice.
  bool impacts_dominate() const;
};

/// What one component was over a window of a run that begins at `start` in steps of `h` [s]. `ice_broke`: before the
/// window's end, so that the load remembers long.
ComponentLoad component_load(const std::vector<double>& series, const LoadWindow& window, double start, double h,
                             double filter, bool ice_broke = false);

/// A body that the scene holds fixed.
struct StructureLoad {
  std::string name;
  IceLoad ice;                                               ///< without tow
  std::vector<std::pair<std::string, ComponentLoad>> loads;  ///< by column name, without the structure's
};

}  // namespace nilas
