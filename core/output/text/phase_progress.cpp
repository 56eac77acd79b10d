#include "core/output/text/phase_progress.h"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <utility>

namespace nilas::output {

ConsoleStyle phase_style(bool quiet, bool json) {
  if (quiet) return ConsoleStyle::silent;
  if (::isatty(STDERR_FILENO) != 0) return ConsoleStyle::terminal;
  return json ? ConsoleStyle::silent : ConsoleStyle::plain;
}

PhaseProgress::PhaseProgress(std::ostream& out, ConsoleStyle style, std::string phase, const PhaseTimes& times)
    : out_(out),
      style_(style),
      line_(std::make_shared<StatusLine>(out)),
      lines_(style, std::move(phase), now(), times) {
  if (style_ != ConsoleStyle::silent) thread_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

PhaseProgress::~PhaseProgress() { end(); }

void PhaseProgress::make_room_for(spdlog::logger& logger) const {
  if (style_ == ConsoleStyle::terminal) make_room(logger, line_);
}

void PhaseProgress::next(std::string phase) {
  const std::lock_guard hold(mutex_);
  lines_.next(std::move(phase), now());
  changed_.notify_all();
}

void PhaseProgress::end() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
  line_->erase();
}

void PhaseProgress::watch(const std::stop_token& stop) {
  std::unique_lock hold(mutex_);
  while (!stop.stop_requested()) {
    if (const std::optional<std::string> line = lines_.line(now())) tell(*line);
    const double due = lines_.due();
    changed_.wait_for(hold, stop, std::chrono::duration<double>(due - now()), [&] { return lines_.due() != due; });
  }
}

void PhaseProgress::tell(const std::string& line) {
  if (style_ == ConsoleStyle::terminal)
    line_->draw(line.substr(0, k_console_columns - 1));
  else
    out_ << line + "\n" << std::flush;
}

}  // namespace nilas::output
