#include "core/output/phase_progress.h"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <utility>

namespace nilas {

ConsoleStyle phase_style(bool quiet, bool json) {
  if (quiet) return ConsoleStyle::silent;
  if (::isatty(STDERR_FILENO) != 0) return ConsoleStyle::terminal;
  return json ? ConsoleStyle::silent : ConsoleStyle::plain;
}

PhaseProgress::PhaseProgress(std::ostream& out, ConsoleStyle style, std::string phase, PhaseTimes times)
    : out_(out), style_(style), times_(times), line_(std::make_shared<StatusLine>(out)), phase_(std::move(phase)) {
  if (style_ != ConsoleStyle::silent) thread_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

PhaseProgress::~PhaseProgress() { end(); }

void PhaseProgress::make_room_for(spdlog::logger& logger) const {
  if (style_ == ConsoleStyle::terminal) make_room(logger, line_);
}

void PhaseProgress::next(std::string phase) {
  const std::lock_guard hold(mutex_);
  phase_ = std::move(phase);
  since_ = Clock::now();
  is_new_ = true;
  changed_.notify_all();
}

void PhaseProgress::end() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
  line_->erase();
}

void PhaseProgress::watch(const std::stop_token& stop) {
  const auto seconds = [](double s) {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(s));
  };
  std::unique_lock hold(mutex_);
  changed_.wait_for(hold, stop, seconds(times_.first), [] { return false; });
  while (!stop.stop_requested()) {
    if (std::exchange(is_new_, false)) {
      changed_.wait_for(hold, stop, seconds(times_.settle), [this] { return is_new_; });
      continue;
    }
    tell();
    const double pause = style_ == ConsoleStyle::terminal ? times_.redraw : times_.again;
    changed_.wait_for(hold, stop, seconds(pause), [this] { return is_new_; });
  }
}

void PhaseProgress::tell() {
  const double so_far = std::chrono::duration<double>(Clock::now() - since_).count();
  const std::string text = phase_ + (so_far < 1 ? "" : ", " + duration_text(std::floor(so_far)) + " so far");
  if (style_ == ConsoleStyle::terminal)
    line_->draw(text.substr(0, k_console_columns - 1));
  else
    out_ << text + "\n" << std::flush;
}

}  // namespace nilas
