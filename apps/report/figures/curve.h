#pragma once
/// Curves and plots of a report, as the page and the figures for papers draw them.
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace nilas::report {

/// One line of a plot. Values that are not finite leave a gap.
struct Curve {
  std::string name = {};                    ///< as the legend shows it
  std::vector<double> x = {}, y = {};       ///< in the units of the plot's labels
  std::vector<double> low = {}, high = {};  ///< range of y about each x; empty: none
  bool is_dots = false;                     ///< true: single points
  bool is_steps = false;                    ///< true: y holds until the next x
};

/// A marked value.
struct Level {
  std::string name = {};
  double y = 0;
  double half_width = 0;  ///< of a band about it; 0: none
};

struct Plot {
  std::string id = {};  ///< letters and hyphens, also the name of the figure's files
  std::string title = {}, x_label = {}, y_label = {};
  std::vector<Curve> curves = {};
  bool log_x = false, log_y = false;
  std::vector<Level> levels = {};
  bool over_time = false;                             ///< true: x is the time of the run, so such plots zoom together
  std::optional<std::array<double, 2>> y_range = {};  ///< shown while all of x is; empty: that of all values
};

}  // namespace nilas::report
