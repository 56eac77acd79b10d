#pragma once
/// The error of the mean loads of a run: docs/theory/load-error.md.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/output/loads/load_window.h"
#include "core/output/loads/step_series.h"
#include "core/output/loads/twin_statistics.h"
#include "core/output/tables/vessel_channels.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

/// The residuals of each step as loads: components fx fy fz mx my mz of the contact load, then along and across the
/// course. They stand in columns of a table of steps.
class LoadResiduals {
 public:
  static constexpr std::size_t k_components = 6 + k_num_course_loads;
  static constexpr std::size_t k_columns = 2 + 2 * k_components;

  /// `columns`: those that add_to() fills.
  explicit LoadResiduals(SeriesPart columns) : columns_(columns) {}
  /// Adds the columns of a step of a run with a vessel to a row.
  static void add_to(std::vector<double>& row, const sim::StepRecord& record);
  /// Mean of the solver's residual over the steps of a window, in absolute values, without cancellation.
  double solver(std::size_t component, const LoadWindow& window) const;
  /// Residual of the contact law over the steps of a window: |mean| and twice its standard error.
  double law(std::size_t component, const LoadWindow& window) const;
  /// Share of the window's steps in which the solver missed the scene's tolerance. Where ice broke, it includes steps
  /// whose residual exceeds a thousandth of the carriage's speed.
  double share_short(const LoadWindow& window, bool ice_broke) const;

 private:
  /// The first columns: 1 in steps that were short (or coarse), else 0; then solver's residuals and those of the law.
  static constexpr std::size_t k_short = 0, k_coarse = 1, k_solver = 2, k_law = k_solver + k_components;

  SeriesPart columns_;
};

/// The error of one channel's mean over the window, in the channel's unit, as half widths for about 95 % of runs.
struct ChannelError {
  std::string channel;
  double mean = 0;             ///< mean; with perturbed runs over all runs
  double solver = 0, law = 0;  ///< values of one run
  std::optional<double> chaos;
  double total = 0;  ///< root of the sum of squares of chaos and of solver + law
};

struct LoadError {
  std::vector<ChannelError> channels;
  std::size_t headline = 0;      ///< index of the channel ice_resistance_N, where there is one
  double share_short = 0;        ///< share of the window's steps that were not solved well enough
  bool solver_at_least = false;  ///< true if these are so many that the errors `solver` and `total` are lower bounds
  bool law_at_least = false;     ///< true if the law errs: what that does to the motion of the ice is not in `law`
  bool from_twins = false;       ///< true if the mean is over several runs
  bool chaos_from_twins = false;
  bool ice_broke = false;  ///< true if ice broke before the window's end: the load then has a long memory

  /// Whether the errors `total` are lower bounds.
  bool at_least() const { return solver_at_least || law_at_least; }
};

/// Load channels of a run, with one value per step.
struct LoadRecord {
  const std::vector<std::string>& names;
  SeriesPart series;       ///< a column per channel
  LoadWindow window;       ///< the window over which loads are averaged
  bool ice_broke = false;  ///< true if ice broke before the window's end
};

/// The errors of all channels; empty without a contact channel or a step. Chaos is that of the perturbed runs where
/// they diverged in the first half of the window. Otherwise it is the larger of theirs and the run's own, which is that
/// of a load with long memory where ice broke. For hull and carriage, the run's own chaos is that of the contact load,
/// because the carriage's load on the vessel's mass is not random.
std::optional<LoadError> load_error(const LoadRecord& run, const LoadResiduals& residuals, const TwinStatistics* twins);

}  // namespace nilas::output
