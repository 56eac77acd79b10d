/// Tests of the thread that prints phases. phase_lines_test.cpp tests the timing: here no line is due, or all at once.
#include "core/output/text/phase_progress.h"

#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>

#include <sstream>

namespace nilas::output {
namespace phase_progress_test {

constexpr PhaseTimes k_at_once{.first = 0, .settle = 0, .redraw = 1e6, .again = 1e6}, k_never{.first = 1e6};

/// A stream that one thread writes and another waits for.
class WatchedText : public std::stringbuf {
 public:
  /// Waits until as much has been flushed.
  void wait_for(const std::string& text) {
    std::unique_lock hold(mutex_);
    flushed_.wait(hold, [&] { return text_ == text; });
  }
  std::string text() {
    const std::lock_guard hold(mutex_);
    return text_;
  }

 private:
  int sync() override {
    const std::lock_guard hold(mutex_);
    text_ = str();
    flushed_.notify_all();
    return 0;
  }

  std::mutex mutex_;
  std::condition_variable flushed_;
  std::string text_;
};

TEST(PhaseProgress, SaysNothingWhileNothingIsDue) {
  for (const ConsoleStyle style : {ConsoleStyle::plain, ConsoleStyle::terminal}) {
    std::ostringstream out;
    { PhaseProgress(out, style, "packing", k_never).next("cutting"); }
    EXPECT_EQ(out.str(), "");
  }
}

TEST(PhaseProgress, SaysNothingWhenSilent) {
  std::ostringstream out;
  { PhaseProgress(out, ConsoleStyle::silent, "packing", k_at_once).next("cutting"); }
  EXPECT_EQ(out.str(), "");
}

TEST(PhaseProgress, PrintsALinePerPhaseAndNoneAfterItsEnd) {
  WatchedText text;
  std::ostream out(&text);
  PhaseProgress progress(out, ConsoleStyle::plain, "mending", k_at_once);
  text.wait_for("mending\n");
  progress.next("cutting");  // brings the next line forward, by days
  text.wait_for("mending\ncutting\n");
  progress.end();
  progress.next("drawing");
  EXPECT_EQ(text.text(), "mending\ncutting\n");
}

TEST(PhaseProgress, ATerminalHasOneLineThatIsGoneAtTheEnd) {
  WatchedText text;
  std::ostream out(&text);
  const std::string erase = "\r\x1b[K";
  PhaseProgress progress(out, ConsoleStyle::terminal, "packing", k_at_once);
  text.wait_for(erase + "packing");
  progress.next("cutting");
  text.wait_for(erase + "packing" + erase + "cutting");
  progress.end();
  EXPECT_EQ(text.text(), erase + "packing" + erase + "cutting" + erase);
}

TEST(PhaseProgress, GivesWayToMessages) {
  WatchedText text;
  std::ostream out(&text);
  spdlog::logger logger("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(out, true));
  logger.set_pattern("%v");
  PhaseProgress progress(out, ConsoleStyle::terminal, "packing", k_at_once);
  progress.make_room_for(logger);
  text.wait_for("\r\x1b[Kpacking");
  logger.warn("thin ice");
  progress.end();
  logger.warn("again");
  EXPECT_EQ(text.text(), "\r\x1b[Kpacking\r\x1b[Kthin ice\nagain\n");
}

}  // namespace phase_progress_test
}  // namespace nilas::output
