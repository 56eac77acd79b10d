/// The figures that are read back are those that a run wrote.
#include "core/output/run/run_summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/support/scratch_folder.h"

namespace run_summary_test {

using namespace nilas;
using namespace nilas::output;
using Json = nlohmann::ordered_json;

/// A summary as summary_json() writes it, without the entries that are not read back.
Json written() {
  return {
      {"scene", "tow"},
      {"status", "done"},
      {"time_end_s", 12.5},
      {"steps", 1250},
      {"wall_s", 5.0},
      {"real_time_factor", 2.5},
      {"ice", {{"floes", 9}, {"floes_end", 8}}},
      {"worst",
       {{"penetration_max_m", {{"value", 1e-3}, {"time_s", 1.0}}},
        {"imbalance_J", {{"value", 3.0}, {"relative_to_energy_put_in", 1e-9}}},
        {"momentum_imbalance_relative", {{"value", 1e-12}}},
        {"law_map_m_s", {{"value", 1e-7}, {"time_s", 2.0}}}}},
      {"shortfalls", {{"unconverged_steps", 4}}},
      {"window", {{"from_s", 2.0}, {"to_s", 12.5}, {"steps", 1050}, {"reason", "after the ramp"}}},
      {"ice_load", {{"touched", true}}},
      {"loads",
       {{"ice_resistance_N", {{"mean", 10.0}, {"std", 2.0}, {"max", 30.0}, {"p99", 25.0}}},
        {"a/b~c_N", {{"mean", 1.0}, {"std", 0.0}, {"max", 1.0}, {"p99", 1.0}}}}},
      {"load_error",
       {{"channels", {{"ice_resistance_N", {{"estimate", 1.0}, {"solver", 0.5}, {"law", 0.25}, {"chaos", nullptr}}}}}}},
      {"modules", {{"ms_per_step", {{"solver", 4.0}}}}},
      {"seed", 7}};
}

void expect_same(const RunSummary& summary) {
  EXPECT_TRUE(summary.exists());
  EXPECT_EQ(summary.scene, "tow");
  EXPECT_EQ(summary.ended_early, "");
  EXPECT_EQ(summary.seed, 7U);
  EXPECT_EQ(summary.time_end_s, 12.5);
  EXPECT_EQ(summary.steps, 1250);
  EXPECT_EQ(summary.floes_end, 8);
  EXPECT_EQ(summary.unconverged_steps, 4);
  EXPECT_EQ(summary.penetration_max_m, 1e-3);
  EXPECT_EQ(summary.imbalance_relative, 1e-9);
  EXPECT_EQ(summary.momentum_imbalance_relative, 1e-12);
  EXPECT_EQ(summary.residuals.law_map_m_s, 1e-7);
  EXPECT_TRUE(std::isnan(summary.residuals.natural_map_m_s)) << "it is not there";
  EXPECT_EQ(summary.window, (LoadSpan{2, 12.5, "after the ramp"}));
  EXPECT_EQ(summary.touched, true);
  EXPECT_EQ(summary.phase_ms[static_cast<std::size_t>(sim::Phase::solver)], 4);
  EXPECT_EQ(summary.phase_ms[static_cast<std::size_t>(sim::Phase::output)], 0) << "a phase without work takes no time";
  ASSERT_EQ(summary.loads.size(), 2U);
  EXPECT_EQ(summary.loads.front().first, "ice_resistance_N");
  EXPECT_EQ(summary.load("ice_resistance_N")->p99, 25);
  EXPECT_EQ(summary.load("a/b~c_N")->mean, 1) << "names of a user's own";
  EXPECT_EQ(summary.load("tow"), nullptr);
  EXPECT_EQ(summary.load_errors.at("ice_resistance_N").solver, 0.5);
  EXPECT_TRUE(std::isnan(summary.load_errors.at("ice_resistance_N").chaos));
}

TEST(RunSummary, IsReadFromASummaryAndFromItsOwnExcerpt) {
  const RunSummary summary = run_summary_from(written());
  expect_same(summary);
  expect_same(run_summary_from(to_json(summary)));
}

TEST(RunSummary, OfARunThatLeftNoneKnowsNothing) {
  const nilas::test::ScratchFolder folder;
  for (const RunSummary& none : {RunSummary{}, read_run_summary(folder.path()), run_summary_from(nullptr)}) {
    EXPECT_FALSE(none.exists());
    EXPECT_TRUE(std::isnan(none.time_end_s));
    EXPECT_TRUE(std::isnan(none.phase_ms[0]));
    EXPECT_FALSE(none.window);
    EXPECT_TRUE(to_json(none).is_null());
  }
  std::ofstream(folder.path() / "summary.json") << "{ cut off";
  EXPECT_FALSE(read_run_summary(folder.path()).exists());
}

}  // namespace run_summary_test
