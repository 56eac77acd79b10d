#pragma once
/// Statistics over a run and its perturbed runs (twins), whose bodies start up to 1e-12 m away.
#include <optional>
#include <string>
#include <vector>

#include "core/bodies/bodies.h"

namespace nilas::output {

/// A perturbed run whose numerics failed. It does not count from that time on.
struct FailedTwin {
  std::uint64_t twin = 0;
  double time = 0;  ///< [s]
  std::string message;
};

struct TwinStatistics {
  int count = 0;  ///< number of perturbed runs requested
  std::vector<std::string> load_names;
  /// Mean over the run itself and over each perturbed run that did not fail, per load channel.
  std::vector<std::vector<double>> mean_loads;
  double threshold = 0;             ///< distance that defines the horizon [m]
  std::optional<double> horizon;    ///< time of the horizon; empty: never reached [s]
  std::optional<double> e_folding;  ///< [s]
  std::vector<FailedTwin> failed;

  std::size_t runs() const { return mean_loads.empty() ? 0 : mean_loads.front().size(); }
};

/// Follows the largest distance of the same body between any two runs. The horizon is the first time when it exceeds
/// 1e-4 of the mean diameter (of the bounding sphere) of the freely moving bodies, or when the runs no longer have the
/// same bodies. The e-folding time is that of the exponential fitted to all distances between ten times the first
/// offset and the threshold.
class TwinHorizon {
 public:
  explicit TwinHorizon(const bodies::Bodies& start);

  /// Compares the runs at time t [s]. Call once per step.
  void compare(double t, const std::vector<const bodies::Bodies*>& runs);
  double threshold() const { return threshold_; }
  std::optional<double> horizon() const { return horizon_; }
  /// The e-folding time [s]; empty before the horizon, or where fewer than ten steps lie in the fitted range.
  std::optional<double> e_folding() const;

 private:
  double threshold_ = 0;
  std::optional<double> horizon_;
  std::vector<double> times_, logs_;
};

}  // namespace nilas::output
