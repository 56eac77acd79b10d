#pragma once
/// What a person sees while a scene runs.
#include <spdlog/logger.h>

#include <functional>
#include <memory>
#include <ostream>
#include <string>

#include "core/output/text/status_line.h"

namespace nilas {

/// terminal: one line that redraws itself; plain: a line every 5 %; silent: nothing.
enum class ConsoleStyle { terminal, plain, silent };
/// From the flags and whether standard output is a terminal.
ConsoleStyle console_style(bool silent);

constexpr int k_console_columns = 80;

/// `text` broken at blanks to 80 columns; every line but the first indented, the first printed from that column on.
std::string wrapped(const std::string& text, std::size_t indent);

/// Wall-clock seconds from any origin.
using WallClock = std::function<double()>;
double steady_seconds();

/// How far a run is.
struct RunProgress {
  double t = 0, t_start = 0, t_end = 0;  ///< simulated [s]
  long steps = 0;
  double wall = 0;    ///< [s] since the first step began
  double before = 0;  ///< simulated by an earlier session of the run, which `steps` and `wall` know nothing of [s]

  double now() const { return t - t_start - before; }  ///< simulated by this session [s]
  double share() const;                                ///< of the whole run, 0 .. 1
  double real_time_factor() const;                     ///< simulated over wall time
};
/// Percent, simulated and total time, step rate, real-time factor, remaining time; with a bar where the width has room
/// for it. At most `width` characters.
std::string progress_text(const RunProgress& progress, int width, bool bar);
/// 8.31 s, 1 min 23 s, 2 h 03 min.
std::string duration_text(double seconds);

/// Draws progress. Log messages of loggers made known to it appear above the line.
class Console {
 public:
  /// `out` must outlive the console and the loggers that know it. Times are those of the scene [s].
  Console(std::ostream& out, ConsoleStyle style, double t_start, double t_end, WallClock clock = steady_seconds);
  ~Console();

  /// Makes `logger` erase the progress line before its messages.
  void make_room_for(spdlog::logger& logger);
  /// Tells that the run begins at time t [s], after what an earlier session did.
  void go_on_from(double t) { before_ = t - t_start_; }
  /// `steps` of this session. Draws when it is time to: at most 10 times a second on a terminal, once per 5 % else.
  void progress(double t, long steps);
  /// Erases the progress line and prints `text`, unless silent.
  void close(const std::string& text);
  double wall_seconds() const { return clock_() - wall_start_; }

 private:
  std::ostream& out_;
  ConsoleStyle style_;
  double t_start_, t_end_, before_ = 0;
  WallClock clock_;
  double wall_start_;
  double last_drawn_;
  int next_mark_ = 1;  ///< in units of 5 %
  std::shared_ptr<StatusLine> line_;
};

}  // namespace nilas
