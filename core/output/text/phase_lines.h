#pragma once
/// The lines about phases of a command, and when each is due. It knows no clock but the times that it is given.
#include <optional>
#include <string>

#include "core/output/text/console.h"

namespace nilas {

/// When a phase is spoken of [s].
struct PhaseTimes {
  double first = 2;     ///< after the start of the command; shorter ones stay silent
  double settle = 0.5;  ///< after the start of a later phase; shorter ones are passed over
  double redraw = 1;    ///< on a terminal
  double again = 10;    ///< else: the next line about a phase that goes on
};

/// All times [s] are of one clock, whichever.
class PhaseLines {
 public:
  /// The command starts at `now` with `phase`: "reading the mesh".
  PhaseLines(ConsoleStyle style, std::string phase, double now, const PhaseTimes& times = {});

  void next(std::string phase, double now);
  /// When the next line is due, if no other phase begins before.
  double due() const { return due_; }
  /// The line, where one is due at `now`: "reading the mesh, 3 s so far".
  std::optional<std::string> line(double now);

 private:
  PhaseTimes times_;
  double pause_;  ///< between two lines about the same phase
  std::string phase_;
  double first_, since_, due_;  ///< no line before first_; the phase's start; the next line
};

}  // namespace nilas
