#pragma once
/// The time window of a run over which loads are averaged.
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace nilas::output {

/// Steps first .. last - 1 of a run: those that end after `from` and not after `to`.
struct LoadWindow {
  double from = 0, to = 0;  ///< [s]
  std::size_t first = 0, last = 0;
  std::string reason;  ///< reason for its begin, as the end of a sentence

  std::size_t steps() const { return last - first; }
  /// The entries of a series (one value per step) within the window.
  std::vector<double> of(const std::vector<double>& series) const;
};

/// The facts from which a window is chosen.
struct LoadCourse {
  double start = 0, h = 0;  ///< start of the run, length of its steps [s]
  std::size_t steps = 0;
  std::optional<std::array<double, 2>> asked;  ///< requested window: from, to [s]
  std::optional<double> ramp_end;              ///< end of the carriage's ramp [s]
  std::optional<double> first_ice;             ///< start of the first step in which ice pressed [s]
};

/// The requested window, where the run has steps there. Otherwise from the first contact with ice or the end of the
/// ramp, whichever is later, to the end of the run. A ramp that outlasts the run is ignored, and the reason says so.
LoadWindow load_window(const LoadCourse& course);

}  // namespace nilas::output
