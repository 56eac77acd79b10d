#pragma once
/// How well dynamic positioning keeps its station, over a window of time.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/state.h"
#include "core/bodies/module.h"

namespace nilas::vessel {

/// Names of the sums over the run by which outputs ask for them. They are 0 before the window begins.
inline constexpr std::string_view k_dp_time = "dp_time";                          ///< time within the window [s]
inline constexpr std::string_view k_dp_offset_rms = "dp_offset_rms";              ///< distance from the set-point [m]
inline constexpr std::string_view k_dp_offset_max = "dp_offset_max";              ///< [m]
inline constexpr std::string_view k_dp_heading_rms = "dp_heading_rms";            ///< heading error [rad]
inline constexpr std::string_view k_dp_heading_max = "dp_heading_max";            ///< [rad]
inline constexpr std::string_view k_dp_outside = "dp_time_outside";               ///< time outside the watch circle [s]
inline constexpr std::string_view k_dp_alarms = "dp_alarms";                      ///< how often it was left
inline constexpr std::string_view k_dp_thrust_use = "dp_thrust_use";              ///< mean share of the largest thrust
inline constexpr std::string_view k_dp_saturation_share = "dp_saturation_share";  ///< share of time with a shortfall

/// What holds over one substep.
struct StationSample {
  double offset = 0;         ///< distance from the set-point [m]
  double heading_error = 0;  ///< [rad]
  double thrust_use = 0;     ///< sum of all |thrust| over that of all limits
  bool saturated = false;
  double force_shortfall = 0, moment_shortfall = 0;  ///< magnitudes of what the thrusters do not give [N, N m]
};

class StationStatistics {
 public:
  /// `from`, `to`: the window [s]; `watch_circle`: radius [m], empty: none.
  StationStatistics(double from, double to, std::optional<double> watch_circle)
      : from_(from), to_(to), watch_circle_(watch_circle) {}
  /// Adds a substep of length h [s] that ends at t [s]; it counts where its middle lies within the window.
  void add(const StationSample& sample, double t, double h);
  bool outside() const { return outside_ != 0; }
  /// The same for summary.json and the closing account. Without a watch circle, without its figures.
  std::vector<bodies::RunFigure> figures() const;
  /// One of the names above; empty for any other.
  std::optional<double> total(std::string_view name) const;

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  std::string saturation_text(double share) const;

  double from_, to_;
  std::optional<double> watch_circle_;
  double time_ = 0, offset_squared_ = 0, offset_max_ = 0, heading_squared_ = 0, heading_max_ = 0;
  double outside_time_ = 0, thrust_ = 0, saturated_time_ = 0;
  double force_shortfall_ = 0, moment_shortfall_ = 0;  ///< greatest [N, N m]
  long alarms_ = 0;
  int outside_ = 0;
};

}  // namespace nilas::vessel
