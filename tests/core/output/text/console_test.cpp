#include "core/output/text/console.h"

#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>

#include <sstream>

#include "core/output/run/closing_account.h"
#include "tests/core/output/sample_run.h"
#include "tests/support/file_text.h"

namespace nilas::output {
namespace console_test {

TEST(ProgressText, SaysPercentTimesRateFactorAndRemaining) {
  const RunProgress progress{15, 0, 60, 1500, 30};
  EXPECT_EQ(progress_text(progress, 80, false), " 25 %  15.00/60 s  50 steps/s  0.5 x real time  1 min 30 s left");
  EXPECT_EQ(progress_text(progress, 80, true).substr(0, 15), "[###...........");
}

TEST(ProgressText, OfARunThatGoesOnCountsThisSessionsTimeOnly) {
  const RunProgress progress{40, 0, 60, 1000, 20, 30};  // 10 s simulated in 20 s
  EXPECT_EQ(progress_text(progress, 80, false), " 66 %  40.00/60 s  50 steps/s  0.5 x real time  40 s left");
}

TEST(ProgressText, FitsTheWidthWhateverTheNumbers) {
  for (const double t_end : {1e-3, 60.0, 123456789.5})
    for (const double wall : {0.0, 1e-6, 12.0, 3e6})
      for (const double share : {0.0, 0.013, 0.5, 1.0})
        EXPECT_LE(progress_text({share * t_end, 0, t_end, 1234567, wall}, 79, true).size(), 79u);
}

TEST(DurationText, ReadsLikeATime) {
  EXPECT_EQ(duration_text(0.0123), "0.0123 s");
  EXPECT_EQ(duration_text(8.3149), "8.31 s");
  EXPECT_EQ(duration_text(83), "1 min 23 s");
  EXPECT_EQ(duration_text(3599.7), "1 h 00 min");
  EXPECT_EQ(duration_text(2 * 3600 + 3 * 60 + 10), "2 h 03 min");
}

TEST(PercentText, HasTwoDigitsAndNoExponent) {
  EXPECT_EQ(percent_text(0.000125), "0.013 %");
  EXPECT_EQ(percent_text(0.0521), "5.2 %");
  EXPECT_EQ(percent_text(0.52125), "52 %");
  EXPECT_EQ(percent_text(1), "100 %");
}

TEST(Console, WithoutATerminalPrintsALineEveryFivePercent) {
  std::ostringstream out;
  double now = 0;
  Console console(out, ConsoleStyle::plain, 0, 1, [&] { return now; });
  for (int step = 1; step <= 1000; ++step) {
    now += 0.001;
    console.progress(step * 0.001, step);
  }
  const auto printed = test::split_lines(out.str());
  ASSERT_EQ(printed.size(), 20u);
  for (int k = 0; k < 20; ++k) EXPECT_EQ(std::stoi(printed[k]), 5 * (k + 1));
  EXPECT_EQ(out.str().find('\x1b'), std::string::npos);
}

TEST(Console, ATerminalLineIsRedrawnTenTimesASecondAtMost) {
  std::ostringstream out;
  double now = 0;
  Console console(out, ConsoleStyle::terminal, 0, 10, [&] { return now; });
  for (int step = 1; step <= 1000; ++step) {
    now += 0.001;
    console.progress(step * 0.01, step);
  }
  const std::string text = out.str();
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 10);
}

TEST(Console, LogMessagesStandAboveTheLine) {
  std::ostringstream out;
  double now = 0;
  spdlog::logger logger("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(out));
  logger.set_pattern("%v");
  Console console(out, ConsoleStyle::terminal, 0, 10, [&] { return now; });
  console.make_room_for(logger);
  now = 1;
  console.progress(5, 1);
  out.str("");
  logger.warn("thin ice");
  logger.warn("again");
  EXPECT_EQ(out.str(), "\r\x1b[Kthin ice\nagain\n");
}

TEST(Console, SaysNothingWhenSilent) {
  std::ostringstream out;
  Console console(out, ConsoleStyle::silent, 0, 1);
  console.progress(0.5, 1);
  console.close("account\n");
  EXPECT_EQ(out.str(), "");
}

TEST(ClosingAccount, ShowsWhereTheTimeWentAndTheWorstValues) {
  RunStatistics statistics(test::full_run());
  statistics.start(0, sim::Ledger{.works = {0, 0}});
  statistics.add(test::full_record(), std::vector<double>(53, 1));
  const std::string text = closing_account(statistics, {.wall_s = 0.056, .processor_s = 0.042}, "runs/sample");
  EXPECT_EQ(text,
            "simulated             0.01 s in 1 steps\n"
            "wall-clock            0.056 s, 0.179 x real time\n"
            "processor time        0.042 s, 0.75 x wall-clock\n"
            "  phase          ms per step  percent\n"
            "  hydro               1.0000      1.8\n"
            "  detection           2.0000      3.6\n"
            "  assembly            3.0000      5.4\n"
            "  solver              4.0000      7.1\n"
            "  integration         5.0000      8.9\n"
            "  fracture            6.0000     10.7\n"
            "  output              7.0000     12.5\n"
            "  other              28.0000     50.0\n"
            "  all                56.0000    100.0\n"
            "worst law residual    1e-07 m/s at 0.01 s\n"
            "worst penetration     0.002 m at 0.01 s\n"
            "worst energy error    1e-12 J at 0.01 s, 6.7e-14 of the energy put in\n"
            "outputs               runs/sample\n");
  for (const auto& line : test::split_lines(text)) EXPECT_LE(line.size(), 80u);
  const std::string resumed = closing_account(statistics, {.wall_s = 0.056, .resuming_s = 0.014}, "runs/sample");
  EXPECT_NE(resumed.find("  resuming           14.0000     25.0\n"
                         "  other              14.0000     25.0\n"
                         "  all                56.0000    100.0\n"),
            std::string::npos)
      << resumed;
  EXPECT_EQ(text.find("not converged"), std::string::npos) << "nothing was missed";
  const std::string broken =
      closing_account(statistics, {.wall_s = 0.056}, "runs/sample", BrokenIce{515, 594, 1234567, 0.0123, 0});
  EXPECT_NE(broken.find("floes                 515 at the start, 594 at the end\n"
                        "ice lost              1.23e+06 kg crushed, 0.0123 kg brash\n"),
            std::string::npos);
  const std::string cut = closing_account(
      statistics,
      {.wall_s = 0.056, .interrupted = "at 0.01 s of 5 s. `nilas run --resume runs/sample` continues the run."},
      "runs/sample");
  EXPECT_EQ(cut.find("interrupted           at 0.01 s of 5 s. `nilas run --resume runs/sample`\n"
                     "                      continues the run.\n"
                     "simulated "),
            0u)
      << cut;
  TwinStatistics twins;
  twins.count = 2;
  twins.horizon = 4.25;
  twins.e_folding = 0.314;
  twins.failed = {{2, 7.5, "left finite numbers"}};
  const std::string with_twins = closing_account(statistics, {.wall_s = 0.056}, "runs/sample", {}, &twins);
  EXPECT_NE(with_twins.find("perturbed runs        2, predictable until 4.25 s, e-folding time 0.31 s\n"
                            "perturbed run         2 failed at 7.5 s\n"),
            std::string::npos)
      << with_twins;
}

/// A thread computes at any time, so 100 s with 40 s of work were spent waiting, and 100 s with 90 s hardly.
TEST(ClosingAccount, SaysThatTheMachineWasBusy) {
  const RunStatistics statistics(test::full_run());
  const std::string busy = closing_account(statistics, {.wall_s = 100, .processor_s = 40}, "runs/sample");
  EXPECT_NE(busy.find("wall-clock            1 min 40 s, 0 x real time\n"
                      "processor time        40 s, 0.4 x wall-clock\n"
                      "  busy machine        Other work on this machine, or a slow disk, made the run\n"
                      "                      wait. Without the waiting it takes about 40 s at most.\n"),
            std::string::npos)
      << busy;
  for (const double processor_s : {90.0, 180.0})
    EXPECT_EQ(closing_account(statistics, {.wall_s = 100, .processor_s = processor_s}, "runs/sample").find("busy"),
              std::string::npos);
}

/// Each share says of which steps it is, and what needs no action says so.
TEST(ClosingAccount, NamesWhatMissedItsGoal) {
  RunStatistics statistics(test::full_run());
  statistics.start(0, sim::Ledger{.works = {0, 0}});
  for (int k = 0; k < 8; ++k) {
    sim::StepRecord record = test::full_record();
    record.solver_short = k < 4;
    record.detection.fallbacks = 3;
    statistics.add(record, std::vector<double>(53, 1));
  }
  const std::string text = closing_account(statistics, {.wall_s = 0.056}, "runs/sample");
  EXPECT_NE(text.find("solver not converged  4 of 8 steps of the whole run (50 %) above the scene's\n"
                      "                      tolerance\n"
                      "collision library     24 queries without a usable answer; the exact search\n"
                      "                      decided them, so no action is needed\n"),
            std::string::npos)
      << text;
}

}  // namespace console_test
}  // namespace nilas::output
