#pragma once
/// Progress of a run on the console.
#include <spdlog/logger.h>

#include <functional>
#include <memory>
#include <ostream>
#include <string>

#include "core/output/text/status_line.h"

namespace nilas::output {

/// Style of progress. terminal: one line that redraws itself; plain: a line every 5 %; silent: nothing.
enum class ConsoleStyle { terminal, plain, silent };
/// The style that follows from the flag and from whether standard output is a terminal.
ConsoleStyle console_style(bool silent);

constexpr int k_console_columns = 80;

/// `text`, wrapped at blanks to 80 columns. All lines but the first are indented; the first is printed from that column
/// on.
std::string wrapped(const std::string& text, std::size_t indent);
/// A line of a run's closing account: the label, and the text wrapped in a column of its own.
std::string account_line(const std::string& label, const std::string& text);

/// Wall-clock seconds from any origin.
using WallClock = std::function<double()>;
double steady_seconds();

/// The progress of a run.
struct RunProgress {
  double t = 0, t_start = 0, t_end = 0;  ///< simulated [s]
  long steps = 0;
  double wall = 0;    ///< wall time since the first step began [s]
  double before = 0;  ///< time that an earlier session simulated; not in `steps` and `wall` [s]

  double now() const { return t - t_start - before; }  ///< time that this session simulated [s]
  double share() const;                                ///< share of the whole run, 0 .. 1
  double real_time_factor() const;                     ///< simulated over wall time
};
/// A line of at most `width` characters: percent, simulated and total time, step rate, real-time factor, remaining
/// time; with a bar where there is room.
std::string progress_text(const RunProgress& progress, int width, bool bar);
/// A duration as text: 8.31 s, 1 min 23 s, 2 h 03 min.
std::string duration_text(double seconds);
/// A share as percent with two digits: 0.013 %, 5.2 %, 52 %, 100 %.
std::string percent_text(double share);

/// Draws progress. Log messages of loggers given to make_room_for() appear above the line.
class Console {
 public:
  /// `out` must outlive the console and the loggers that know it. Times are those of the scene [s].
  Console(std::ostream& out, ConsoleStyle style, double t_start, double t_end, WallClock clock = steady_seconds);
  ~Console();

  /// Makes `logger` erase the progress line before its messages.
  void make_room_for(spdlog::logger& logger);
  /// Sets the time t [s] at which this session continues the run.
  void go_on_from(double t) { before_ = t - t_start_; }
  /// Notes the progress; `steps`: of this session. Draws at most 10 times a second on a terminal, else once per 5 %.
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
  int next_mark_ = 1;  ///< next line to print, in units of 5 %
  std::shared_ptr<StatusLine> line_;
};

}  // namespace nilas::output
