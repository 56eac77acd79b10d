#include "core/vessel/control/station_statistics.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace station_statistics_test {

using namespace nilas;
using vessel::StationSample;
using vessel::StationStatistics;

double value(const StationStatistics& statistics, std::string_view name) { return statistics.total(name).value(); }

std::map<std::string, bodies::RunFigure> by_name(const StationStatistics& statistics) {
  std::map<std::string, bodies::RunFigure> figures;
  for (const auto& figure : statistics.figures()) figures[figure.name] = figure;
  return figures;
}

/// Steps of 1 s; the window is 10 s to 20 s, the watch circle 5 m.
StationStatistics after(const std::vector<double>& offsets) {
  StationStatistics statistics(10, 20, 5);
  double t = 0;
  for (const double offset : offsets) statistics.add({.offset = offset}, ++t, 1);
  return statistics;
}

TEST(StationStatistics, CountsAnAlarmEachTimeTheCircleIsLeft) {
  std::vector<double> offsets(30, 1);
  for (const std::size_t k : {5u, 12u, 13u, 17u, 25u}) offsets[k] = 6;
  const StationStatistics statistics = after(offsets);
  EXPECT_EQ(value(statistics, vessel::k_dp_alarms), 2) << "those at 13 s and 18 s lie in the window";
  EXPECT_EQ(value(statistics, vessel::k_dp_outside), 3);
  EXPECT_EQ(value(statistics, vessel::k_dp_offset_max), 6);
}

/// A vessel that left its circle before the window begins, and is still outside, raises one alarm in it.
TEST(StationStatistics, CountsAVesselThatIsOutsideWhereTheWindowBegins) {
  std::vector<double> offsets(30, 1);
  for (std::size_t k = 8; k < 14; ++k) offsets[k] = 6;
  const StationStatistics statistics = after(offsets);
  EXPECT_EQ(value(statistics, vessel::k_dp_alarms), 1);
  EXPECT_EQ(value(statistics, vessel::k_dp_outside), 4);
}

/// Short of thrust for 3 of 10 s; the greatest shortfalls are those while it is saturated.
TEST(StationStatistics, ReportsSaturation) {
  StationStatistics statistics(0, 10, std::nullopt);
  for (int k = 1; k <= 10; ++k)
    statistics.add({.thrust_use = 0.5, .saturated = k > 7, .force_shortfall = 1e4 * k, .moment_shortfall = 2e5}, k, 1);
  EXPECT_NEAR(value(statistics, vessel::k_dp_saturation_share), 0.3, 1e-15);
  const auto some = by_name(statistics), none = by_name(StationStatistics(0, 10, std::nullopt));
  EXPECT_EQ(some.at("force_shortfall_max_N").value, 1e5);
  EXPECT_EQ(some.at("moment_shortfall_max_Nm").value, 2e5);
  EXPECT_EQ(some.at("saturation_share_1").text,
            "in 30 % of the time they gave less than the control wanted, by up to 1e+05 N and 2e+05 N m");
  EXPECT_EQ(none.at("saturation_share_1").text, "never: they gave all that the control wanted");
}

}  // namespace station_statistics_test
