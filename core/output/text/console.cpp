#include "core/output/text/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

namespace nilas::output {

namespace {

constexpr double k_redraw_interval = 0.1;  // [s]
constexpr int k_marks = 20;                // plain lines per run: one every 5 %
/// Tolerance for the rounding of sums of many steps against a whole percent.
constexpr double k_percent_rounding = 1e-9;

}  // namespace

ConsoleStyle console_style(bool silent) {
  if (silent) return ConsoleStyle::silent;
  return ::isatty(STDOUT_FILENO) != 0 ? ConsoleStyle::terminal : ConsoleStyle::plain;
}

std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  std::string out;
  std::size_t column = indent;
  for (std::string word; words >> word;) {
    const bool first = column == indent;
    if (!first && column + 1 + word.size() > static_cast<std::size_t>(k_console_columns)) {
      out += "\n" + std::string(indent, ' ') + word;
      column = indent + word.size();
    } else {
      out += (first ? "" : " ") + word;
      column += word.size() + (first ? 0 : 1);
    }
  }
  return out;
}

std::string account_line(const std::string& label, const std::string& text) {
  constexpr std::size_t k_label_width = 22;
  return fmt::format("{:<{}}{}\n", label, k_label_width, wrapped(text, k_label_width));
}

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double RunProgress::share() const {
  return t_end > t_start ? std::clamp((t - t_start) / (t_end - t_start), 0.0, 1.0) : 1;
}

double RunProgress::real_time_factor() const { return wall > 0 ? now() / wall : 0; }

std::string duration_text(double seconds) {
  constexpr double k_minute = 60, k_hour = 3600;
  if (seconds < k_minute) return fmt::format("{:.3g} s", seconds);
  const long whole = std::lround(seconds);
  const long minutes = whole / static_cast<long>(k_minute);
  if (whole < static_cast<long>(k_hour))
    return fmt::format("{} min {:02} s", minutes, whole % static_cast<long>(k_minute));
  return fmt::format("{} h {:02} min", minutes / static_cast<long>(k_minute), minutes % static_cast<long>(k_minute));
}

std::string percent_text(double share) {
  constexpr double k_percent = 100, k_whole_from = 10;
  const double percent = k_percent * share;
  return percent < k_whole_from ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent);
}

std::string progress_text(const RunProgress& progress, int width, bool bar) {
  constexpr double k_percent = 100;
  constexpr int k_longest_bar = 24, k_brackets = 3;
  const double share = progress.share(),
               rate = progress.wall > 0 ? static_cast<double>(progress.steps) / progress.wall : 0;
  const std::string left =
      progress.now() > 0 ? duration_text(progress.wall * (progress.t_end - progress.t) / progress.now()) : "?";
  std::string text = fmt::format("{:3.0f} %  {:.2f}/{:g} s  {:.3g} steps/s  {:.3g} x real time  {} left",
                                 std::floor(k_percent * share + k_percent_rounding), progress.t, progress.t_end, rate,
                                 progress.real_time_factor(), left);
  const int cells = std::min(width - static_cast<int>(text.size()) - k_brackets, k_longest_bar);
  if (bar && cells > 1) {
    const auto full = static_cast<std::size_t>(share * cells), all = static_cast<std::size_t>(cells);
    text = "[" + std::string(full, '#') + std::string(all - full, '.') + "] " + text;
  }
  return text.substr(0, static_cast<std::size_t>(width));
}

Console::Console(std::ostream& out, ConsoleStyle style, double t_start, double t_end, WallClock clock)
    : out_(out),
      style_(style),
      t_start_(t_start),
      t_end_(t_end),
      clock_(std::move(clock)),
      wall_start_(clock_()),
      last_drawn_(wall_start_ - k_redraw_interval),
      line_(std::make_shared<StatusLine>(out)) {}

Console::~Console() { line_->erase(); }

void Console::make_room_for(spdlog::logger& logger) {
  if (style_ == ConsoleStyle::terminal) make_room(logger, line_);
}

void Console::progress(double t, long steps) {
  if (style_ == ConsoleStyle::silent) return;
  const double now = clock_();
  const RunProgress state{t, t_start_, t_end_, steps, now - wall_start_, before_};
  if (style_ == ConsoleStyle::terminal) {
    if (now - last_drawn_ < k_redraw_interval) return;
    last_drawn_ = now;
    line_->draw(progress_text(state, k_console_columns - 1, true));
    return;
  }
  const int mark = static_cast<int>(state.share() * k_marks + k_percent_rounding);
  if (mark < next_mark_) return;
  next_mark_ = mark + 1;
  out_ << progress_text(state, k_console_columns, false) << std::endl;
}

void Console::close(const std::string& text) {
  if (style_ == ConsoleStyle::silent) return;
  line_->erase();
  out_ << text << std::flush;
}

}  // namespace nilas::output
