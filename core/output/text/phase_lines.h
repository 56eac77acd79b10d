#pragma once
/// The progress lines about phases of a command, and the times when they are due. Uses only the times that it is given.
#include <optional>
#include <string>

#include "core/output/text/console.h"

namespace nilas::output {

/// Delays of the lines about phases [s].
struct PhaseTimes {
  double first = 2;     ///< delay from the command's start; shorter commands print nothing
  double settle = 0.5;  ///< delay from a later phase's start; shorter phases print nothing
  double redraw = 1;    ///< interval of redrawing on a terminal
  double again = 10;    ///< interval of lines about a long phase elsewhere
};

/// The lines about phases. All times [s] are those of one clock with any origin.
class PhaseLines {
 public:
  /// Starts the command at `now` with `phase`, for example "reading the mesh".
  PhaseLines(ConsoleStyle style, std::string phase, double now, const PhaseTimes& times = {});

  void next(std::string phase, double now);
  /// Time when the next line is due, if no other phase begins before.
  double due() const { return due_; }
  /// The line, if one is due at `now`: "reading the mesh, 3 s so far".
  std::optional<std::string> line(double now);

 private:
  PhaseTimes times_;
  double pause_;  ///< interval of lines about the same phase
  std::string phase_;
  double first_, since_, due_;  ///< no line before first_; start of the phase; time of the next line
};

}  // namespace nilas::output
