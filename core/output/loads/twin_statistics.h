#pragma once
/// What a run and its twins, which start next to nothing aside, tell together.
#include <optional>
#include <string>
#include <vector>

#include "core/bodies/bodies.h"

namespace nilas {

/// A twin whose numerics failed: it counts for nothing from there on.
struct FailedTwin {
  std::uint64_t twin = 0;
  double time = 0;  ///< [s]
  std::string message;
};

struct TwinStatistics {
  int count = 0;  ///< twins asked for
  std::vector<std::string> load_names;
  /// Per load channel the mean over the run itself and over each twin that did not fail.
  std::vector<std::vector<double>> mean_loads;
  double threshold = 0;             ///< of the horizon [m]
  std::optional<double> horizon;    ///< nothing: never reached [s]
  std::optional<double> e_folding;  ///< [s]
  std::vector<FailedTwin> failed;

  std::size_t runs() const { return mean_loads.empty() ? 0 : mean_loads.front().size(); }
};

/// Follows how far the same body is apart in any two runs. The horizon is the first time when that exceeds 1e-4 of the
/// mean diameter (of the bounding sphere) of the bodies that move freely, or when the runs do not have the same bodies
/// any more. The e-folding time is that of the exponential fitted to all distances between ten times the first offset
/// and the threshold.
class TwinHorizon {
 public:
  explicit TwinHorizon(const Bodies& start);

  /// Once per step, at time t [s].
  void compare(double t, const std::vector<const Bodies*>& runs);
  double threshold() const { return threshold_; }
  std::optional<double> horizon() const { return horizon_; }
  /// Nothing before the horizon, or where fewer than ten steps lie on the way.
  std::optional<double> e_folding() const;

 private:
  double threshold_ = 0;
  std::optional<double> horizon_;
  std::vector<double> times_, logs_;
};

}  // namespace nilas
