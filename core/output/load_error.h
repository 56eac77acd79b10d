#pragma once
/// What the mean loads of a run are worth: docs/theory_load_error.md.
#include <optional>
#include <string>
#include <vector>

#include "core/base/state.h"
#include "core/output/twin_statistics.h"
#include "core/sim/step_record.h"

namespace nilas {

/// Sums over the steps of a run, per component fx fy fz mx my mz of the contact load.
class LoadResidualSums {
 public:
  void add(const VesselRecord& vessel);
  double solver(std::size_t component, long steps) const;  ///< mean of what the residuals would be if none cancelled
  double law(std::size_t component, long steps) const;     ///< |mean| and twice its standard error

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  std::vector<double> solver_ = std::vector<double>(6), law_ = std::vector<double>(6),
                      law_squares_ = std::vector<double>(6);
};

/// Of one channel's mean over the run, all in the channel's unit; half widths that hold for about 95 % of runs.
struct ChannelError {
  std::string channel;
  double mean = 0;             ///< with twins over all runs
  double solver = 0, law = 0;  ///< of one run
  std::optional<double> chaos;
  double total = 0;  ///< chaos, and the sum of the others, as independent
};

struct LoadError {
  std::vector<ChannelError> channels;
  std::size_t headline = 0;  ///< the largest mean horizontal force, of the carriage where there is one
  bool from_twins = false;   ///< mean
  bool chaos_from_twins = false;
};

/// Load channels of a run from `start` to `end`.
struct LoadRecord {
  const std::vector<std::string>& names;
  const std::vector<std::vector<double>>& series;
  double start = 0, end = 0;  ///< [s]
};

/// Nothing without a contact channel or a step. Chaos is that of the twins where they parted in the first half of the
/// run, else the larger of theirs and the run's own. Of hull and carriage the own one is that of the contact load:
/// what the carriage does to the vessel's mass is no chance.
std::optional<LoadError> load_error(const LoadRecord& run, const LoadResidualSums& residuals,
                                    const TwinStatistics* twins);

}  // namespace nilas
