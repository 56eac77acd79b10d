#pragma once
/// What the mean loads of a run are worth: docs/theory/load-error.md.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/state.h"
#include "core/output/loads/load_window.h"
#include "core/output/loads/twin_statistics.h"
#include "core/output/tables/vessel_channels.h"
#include "core/sim/account/step_record.h"

namespace nilas {

/// Loads that the residuals of each step amount to: components fx fy fz mx my mz of the contact load, then along and
/// across the course.
class LoadResiduals {
 public:
  /// Of a step with a vessel.
  void add(const StepRecord& record);
  /// Over the steps of a window: mean of what the residuals would be if none cancelled.
  double solver(std::size_t component, const LoadWindow& window) const;
  /// Over the steps of a window: |mean| and twice its standard error.
  double law(std::size_t component, const LoadWindow& window) const;
  /// Share of the window's steps in which the solver missed the tolerance that the scene asks for; where ice broke,
  /// also of those in which it left more than a thousandth of the speed that the carriage tows at.
  double share_short(const LoadWindow& window, bool ice_broke) const;

  void save(StateWriter out) const;
  void restore(const StateReader& in, std::size_t steps);

  static constexpr std::size_t k_components = 6 + k_num_course_loads;

 private:
  std::array<std::vector<double>, k_components> solver_, law_;  ///< per step
  std::vector<double> short_, coarse_;                          ///< per step: 1 where so, else 0
};

/// Of one channel's mean over the window, all in the channel's unit; half widths that hold for about 95 % of runs.
struct ChannelError {
  std::string channel;
  double mean = 0;             ///< with twins over all runs
  double solver = 0, law = 0;  ///< of one run
  std::optional<double> chaos;
  double total = 0;  ///< chaos, and the sum of the others, as independent
};

struct LoadError {
  std::vector<ChannelError> channels;
  std::size_t headline = 0;      ///< ice_resistance_N where there is such a channel
  double share_short = 0;        ///< of the window's steps that were not solved well enough
  bool solver_at_least = false;  ///< so many that the solver's part, and with it the total, is a lower bound
  bool from_twins = false;       ///< mean
  bool chaos_from_twins = false;
  bool ice_broke = false;  ///< before the window's end: a run's own chaos is then that of a load with a long memory
};

/// Load channels of a run, with one value per step.
struct LoadRecord {
  const std::vector<std::string>& names;
  const std::vector<std::vector<double>>& series;
  LoadWindow window;       ///< the part of the run that counts
  bool ice_broke = false;  ///< before the window's end
};

/// Nothing without a contact channel or a step. Chaos is that of the twins where they parted in the first half of the
/// window, else the larger of theirs and the run's own, which remembers long where ice broke. Of hull and carriage the
/// own one is that of the contact load: what the carriage does to the vessel's mass is no chance.
std::optional<LoadError> load_error(const LoadRecord& run, const LoadResiduals& residuals, const TwinStatistics* twins);

}  // namespace nilas
