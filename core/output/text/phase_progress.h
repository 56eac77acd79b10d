#pragma once
/// Progress of a command while its results are not available yet.
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <ostream>
#include <string>
#include <thread>

#include "core/output/text/console.h"
#include "core/output/text/phase_lines.h"
#include "core/output/text/status_line.h"

namespace nilas::output {

/// The style for standard error. `json`: another program reads the results, so only a terminal gets progress.
ConsoleStyle phase_style(bool quiet, bool json);

/// Prints the present phase and its duration, from its own thread, so that a phase may be one call of a library. A
/// terminal has one line that is erased at the end. Other outputs get a line per phase and every ten seconds.
class PhaseProgress {
 public:
  /// Starts with `phase`, for example "reading the mesh". `out` must outlive this object.
  PhaseProgress(std::ostream& out, ConsoleStyle style, std::string phase, const PhaseTimes& times = {});
  /// Calls end().
  ~PhaseProgress();
  PhaseProgress(const PhaseProgress&) = delete;
  PhaseProgress& operator=(const PhaseProgress&) = delete;

  /// Makes `logger` erase the line before its messages.
  void make_room_for(spdlog::logger& logger) const;
  void next(std::string phase);
  /// Ends the output; a line on a terminal is erased.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  static double now() { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); }
  void watch(const std::stop_token& stop);
  void tell(const std::string& line);

  std::ostream& out_;
  ConsoleStyle style_;
  std::shared_ptr<StatusLine> line_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  PhaseLines lines_;
  std::jthread thread_;
};

}  // namespace nilas::output
