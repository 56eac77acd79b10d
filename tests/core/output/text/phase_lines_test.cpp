#include "core/output/text/phase_lines.h"

#include <gtest/gtest.h>

namespace nilas::output {
namespace phase_lines_test {

/// Exact in binary, so that times can be met to the bit.
constexpr PhaseTimes k_times{.first = 2, .settle = 0.5, .redraw = 1, .again = 10};
constexpr double k_start = 100;

/// All lines until `end`, each requested at the moment when it is due.
std::string told_until(double end, PhaseLines& lines) {
  std::string all;
  while (lines.due() < end)
    if (const auto line = lines.line(lines.due())) all += *line + "\n";
  return all;
}

TEST(PhaseLines, SayNothingOfWhatIsShort) {
  PhaseLines lines(ConsoleStyle::plain, "packing", k_start, k_times);
  EXPECT_EQ(lines.due(), k_start + 2);
  EXPECT_EQ(lines.line(k_start), std::nullopt);
  EXPECT_EQ(lines.line(k_start + 1.75), std::nullopt);
}

TEST(PhaseLines, TellAPhaseAndAgainWhereItGoesOn) {
  PhaseLines lines(ConsoleStyle::plain, "packing", k_start, k_times);
  EXPECT_EQ(told_until(k_start + 22.5, lines), "packing, 2 s so far\npacking, 12 s so far\npacking, 22 s so far\n");
}

TEST(PhaseLines, OfATerminalAreDrawnEverySecond) {
  PhaseLines lines(ConsoleStyle::terminal, "packing", k_start, k_times);
  EXPECT_EQ(told_until(k_start + 4.5, lines), "packing, 2 s so far\npacking, 3 s so far\npacking, 4 s so far\n");
}

TEST(PhaseLines, PassOverPhasesThatAreShort) {
  PhaseLines lines(ConsoleStyle::plain, "reading", k_start, k_times);
  lines.next("mending", k_start + 0.25);  // The phase lies within the first moments: "reading" is never printed.
  EXPECT_EQ(told_until(k_start + 4, lines), "mending, 1 s so far\n");
  lines.next("sorting", k_start + 4);  // passed over
  lines.next("cutting", k_start + 4.25);
  EXPECT_EQ(lines.due(), k_start + 4.75);
  EXPECT_EQ(told_until(k_start + 15, lines), "cutting\ncutting, 10 s so far\n");
}

TEST(PhaseLines, WaitForAPhaseThatBeginsJustBeforeTheFirstLine) {
  PhaseLines lines(ConsoleStyle::plain, "reading", k_start, k_times);
  lines.next("mending", k_start + 1.75);
  EXPECT_EQ(lines.line(k_start + 2), std::nullopt);
  EXPECT_EQ(lines.line(k_start + 2.25), "mending");
}

TEST(PhaseLines, CountTimeFromWhenTheyAreTold) {
  PhaseLines lines(ConsoleStyle::plain, "packing", k_start, k_times);
  EXPECT_EQ(lines.line(k_start + 5), "packing, 5 s so far");  // the machine was busy
  EXPECT_EQ(lines.due(), k_start + 15);
}

}  // namespace phase_lines_test
}  // namespace nilas::output
