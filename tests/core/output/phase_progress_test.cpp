#include "core/output/phase_progress.h"

#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>

#include <chrono>
#include <sstream>
#include <thread>

namespace nilas {
namespace {

void wait(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// All times a fortieth.
constexpr PhaseTimes k_fast{.first = 0.05, .settle = 0.0125, .redraw = 0.025, .again = 0.25};

std::string said(ConsoleStyle style, double seconds, const PhaseTimes& times) {
  std::ostringstream out;
  {
    const PhaseProgress progress(out, style, "packing", times);
    wait(seconds);
  }
  return out.str();
}

TEST(PhaseProgress, SaysNothingOfWhatIsShort) {
  EXPECT_EQ(said(ConsoleStyle::plain, 0.01, {}), "");
  EXPECT_EQ(said(ConsoleStyle::terminal, 0.01, {}), "");
}

TEST(PhaseProgress, SaysNothingWhenSilent) { EXPECT_EQ(said(ConsoleStyle::silent, 0.2, k_fast), ""); }

TEST(PhaseProgress, PrintsALinePerPhaseAndAgainWhereItGoesOn) {
  std::ostringstream out;
  PhaseProgress progress(out, ConsoleStyle::plain, "reading", k_fast);
  progress.next("mending");  // within the first moments: "reading" is never told
  wait(0.15);
  progress.next("sorting");  // passed over
  progress.next("cutting");
  wait(0.7);
  progress.end();
  const std::string text = out.str();
  progress.next("drawing");
  EXPECT_EQ(out.str(), text) << "after its end";
  EXPECT_EQ(text.rfind("mending\ncutting\ncutting\n", 0), 0u) << text;
}

TEST(PhaseProgress, TellsHowLongAPhaseTakes) {
  const std::string text = said(ConsoleStyle::plain, 1.3, {.first = 1.1, .settle = 0.5, .redraw = 1, .again = 10});
  EXPECT_EQ(text, "packing, 1 s so far\n");
}

TEST(PhaseProgress, ATerminalHasOneLineThatIsGoneAtTheEnd) {
  const std::string text = said(ConsoleStyle::terminal, 0.3, k_fast), erase = "\r\x1b[K";
  EXPECT_EQ(text.rfind(erase + "packing" + erase + "packing", 0), 0u) << text;
  EXPECT_EQ(text.substr(text.size() - erase.size()), erase);
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(PhaseProgress, GivesWayToMessages) {
  std::ostringstream out;
  spdlog::logger logger("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(out));
  logger.set_pattern("%v");
  PhaseProgress progress(out, ConsoleStyle::terminal, "packing",
                         {.first = 0.02, .settle = 0.5, .redraw = 100, .again = 100});
  progress.make_room_for(logger);
  wait(0.3);
  logger.warn("thin ice");
  progress.end();
  logger.warn("again");
  EXPECT_EQ(out.str(), "\r\x1b[Kpacking\r\x1b[Kthin ice\nagain\n");
}

}  // namespace
}  // namespace nilas
