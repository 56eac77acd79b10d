#pragma once
/// The part of a run over which loads are summed up.
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace nilas {

/// Steps first .. last - 1 of a run, those that end after `from` and not after `to`.
struct LoadWindow {
  double from = 0, to = 0;  ///< [s]
  std::size_t first = 0, last = 0;
  std::string reason;  ///< why it begins where it does, as the end of a sentence

  std::size_t steps() const { return last - first; }
  /// The window's part of a series with one value per step.
  std::vector<double> of(const std::vector<double>& series) const;
};

/// What a window is chosen by.
struct LoadCourse {
  double start = 0, h = 0;  ///< of the run, of its steps [s]
  std::size_t steps = 0;
  std::optional<std::array<double, 2>> asked;  ///< from, to [s]
  std::optional<double> ramp_end;              ///< of the carriage [s]
  std::optional<double> first_ice;             ///< start of the first step in which ice pressed [s]
};

/// As asked, where the run has steps there. Else from the first contact with ice or the end of the ramp, whichever is
/// later, to the end of the run; a ramp that outlasts the run is passed over, and the reason says so.
LoadWindow load_window(const LoadCourse& course);

}  // namespace nilas
