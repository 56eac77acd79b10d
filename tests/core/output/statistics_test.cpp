#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/error.h"
#include "core/output/loads/load_statistics.h"
#include "core/output/loads/run_statistics.h"
#include "core/output/run/summary_json.h"
#include "tests/core/output/sample_run.h"

namespace nilas::output {
namespace statistics_test {

using test::full_record;
using test::full_run;

TEST(LoadStatistics, OfAKnownSeries) {
  std::vector<double> series(101);
  std::iota(series.begin(), series.end(), -100.0);  // -100 .. 0
  const LoadStatistics s = load_statistics(series);
  EXPECT_DOUBLE_EQ(s.mean, -50);
  EXPECT_DOUBLE_EQ(s.std, std::sqrt((101.0 * 101.0 - 1) / 12));
  EXPECT_EQ(s.max, 100);
  EXPECT_DOUBLE_EQ(s.p99, 99);
  EXPECT_DOUBLE_EQ(load_statistics({0, 10}).p99, 9.9);
  EXPECT_EQ(load_statistics({-3}).p99, 3);
  EXPECT_EQ(load_statistics({}).max, 0);
}

TEST(RunStatistics, GoOnAsSaved) {
  RunStatistics whole(full_run());
  whole.start(0, sim::Ledger{.works = {0, 0}});
  sim::StepRecord record = full_record();
  State state;
  for (int k = 0; k < 20; ++k) {
    if (k == 12) whole.save(StateWriter(state));
    record.t = 0.01 * (k + 1);
    record.ledger.works = {std::sin(k), std::cos(k)};
    record.ledger.imbalance = k == 5 ? std::numeric_limits<double>::quiet_NaN() : 1e-9 * k;
    record.solver_short = k % 3 == 0;
    whole.add(record, std::vector<double>(53, std::sin(0.1 * k)));
  }
  RunStatistics rest(full_run());
  rest.restore(StateReader(state));
  EXPECT_EQ(rest.steps(), 12);
  for (int k = 12; k < 20; ++k) {
    record.t = 0.01 * (k + 1);
    record.ledger.works = {std::sin(k), std::cos(k)};
    record.ledger.imbalance = 1e-9 * k;
    record.solver_short = k % 3 == 0;
    rest.add(record, std::vector<double>(53, std::sin(0.1 * k)));
  }
  EXPECT_EQ(rest.steps(), whole.steps());
  EXPECT_EQ(rest.end_time(), whole.end_time());
  EXPECT_EQ(rest.energy_put_in(), whole.energy_put_in());
  EXPECT_EQ(rest.total_ms(), whole.total_ms());
  EXPECT_EQ(rest.shortfalls().unconverged_steps, whole.shortfalls().unconverged_steps);
  EXPECT_TRUE(std::isnan(rest.worst("imbalance_J").value)) << "the first value that is no number stays the worst";
  EXPECT_EQ(rest.worst("imbalance_J").time, whole.worst("imbalance_J").time);
  for (std::size_t c = 0; c < whole.load_names().size(); ++c)
    EXPECT_EQ(rest.load_series(c, rest.window()), whole.load_series(c, whole.window()));

  sim::RunInfo other = full_run();
  other.work_names.pop_back();
  EXPECT_THROW(RunStatistics(other).restore(StateReader(state)), InputError);
}

/// Oscillations while the carriage starts do not count as readings of the test.
TEST(RunStatistics, CellsAreTaredAndLeaveTheRampOut) {
  sim::RunInfo info = full_run();
  info.ramp_end = 0.1;
  RunStatistics statistics(info);
  statistics.start(0, sim::Ledger{.works = {0, 0}});
  sim::StepRecord record = full_record();
  record.vessel->touches_ice = false;
  const VesselChannels channels(info);
  for (int k = 0; k < 20; ++k) {
    record.t = 0.01 * (k + 1);
    record.vessel->carriage->cells[0] = k < 10 ? 1000 : info.tare->cells[0] + 5;
    std::vector<double> values;
    channels.read(*record.vessel, values);
    statistics.add(record, values);
  }
  const auto loads = summary_json(info, statistics, {})["loads"];
  EXPECT_EQ(loads["cell1_tared_N"]["mean"], 5);
  EXPECT_EQ(loads["cell1_tared_N"]["max"], 5);
}

TEST(RunStatistics, KeepsTheWorstWithItsTime) {
  RunStatistics statistics(full_run());
  statistics.start(0, sim::Ledger{});
  sim::StepRecord record = full_record();
  const std::vector<double> values(53, 1);
  for (const double x : {1.0, -3.0, 2.0}) {
    record.ledger.imbalance = x;
    record.residuals.natural_map_m_s = std::abs(x);
    statistics.add(record, values);
    record.t += 0.01;
  }
  EXPECT_EQ(statistics.worst("imbalance_J").value, -3);
  EXPECT_DOUBLE_EQ(statistics.worst("imbalance_J").time, 0.02);
  EXPECT_EQ(statistics.worst("natural_map_m_s").value, 3);
  EXPECT_DOUBLE_EQ(statistics.worst("momentum_imbalance_relative").value, 1e-13 / 2);
  EXPECT_EQ(statistics.steps(), 3);
  EXPECT_EQ(statistics.load_series(0, statistics.window()).size(), 3u);
  EXPECT_EQ(statistics.mean_ms(sim::Phase::detection), 2);
}

TEST(RunStatistics, CountsWhatFellShort) {
  RunStatistics statistics(full_run());
  sim::StepRecord record = full_record();
  const std::vector<double> values(53, 1);
  statistics.add(record, values);
  EXPECT_EQ(statistics.shortfalls().unconverged_steps, 0);
  EXPECT_EQ(statistics.shortfalls().uncorrected_steps, 0);
  record.solver_short = true;
  record.positions_corrected = false;
  record.detection.fallbacks = 3;
  for (int k = 0; k < 2; ++k) statistics.add(record, values);
  EXPECT_EQ(statistics.shortfalls().unconverged_steps, 2);
  EXPECT_EQ(statistics.shortfalls().uncorrected_steps, 2);
  EXPECT_EQ(statistics.detection().fallbacks, 6);
}

TEST(RunStatistics, AValueThatIsNotANumberIsTheWorst) {
  RunStatistics statistics(full_run());
  sim::StepRecord record = full_record();
  const std::vector<double> values(53, 1);
  record.residuals.law_map_m_s = std::numeric_limits<double>::quiet_NaN();
  statistics.add(record, values);
  record.residuals.law_map_m_s = 1;
  statistics.add(record, values);
  EXPECT_TRUE(std::isnan(statistics.worst("law_map_m_s").value));
}

TEST(RunStatistics, EnergyPutInAddsTheAbsoluteWorksOfAllSteps) {
  RunStatistics statistics(full_run());
  sim::Ledger start;
  start.kinetic = 2;
  start.works = {0, 0};
  statistics.start(0, start);
  sim::StepRecord record = full_record();
  const std::vector<double> values(53, 1);
  record.ledger.works = {1, -4};
  statistics.add(record, values);
  record.ledger.works = {0, -4};
  record.ledger.imbalance = 0.8;
  statistics.add(record, values);
  EXPECT_DOUBLE_EQ(statistics.energy_put_in(), 2 + 1 + 4 + 1);
  EXPECT_DOUBLE_EQ(statistics.relative_imbalance(), 0.1);
}

TEST(RunStatistics, NothingMissingFromNothingIsABalance) {
  sim::RunInfo info;
  RunStatistics statistics(info);
  statistics.add(sim::StepRecord{}, {});
  EXPECT_EQ(statistics.relative_imbalance(), 0);
  EXPECT_EQ(statistics.worst("momentum_imbalance_relative").value, 0);
}

}  // namespace statistics_test
}  // namespace nilas::output
