/// Loads over windows that runs with other steps share.
#include "apps/compare/scenes/run/load_series.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scratch_folder.h"

namespace load_series_test {

using namespace nilas;
using namespace nilas::compare;

TEST(LoadSeries, KeepsTheCourseLoadsOfARunToTheBit) {
  const test::ScratchFolder folder;
  folder.write("vessel.csv",
               "time_s,contact_fx_N,ice_resistance_N,ice_side_N\n"
               "0.100000000000,-3,3.100000000001,0.5\n0.200000000000,-4,4.000000000000,-0.5\n");
  keep_load_series(folder.path());
  const LoadSeries series = read_load_series(folder.path(), 0);
  EXPECT_EQ(series.end, (std::vector<double>{0.1, 0.2}));
  EXPECT_EQ(series.loads[0], (std::vector<double>{3.100000000001, 4}));
  EXPECT_EQ(series.loads[1], (std::vector<double>{0.5, -0.5}));
}

TEST(LoadSeries, IsEmptyWithoutAVessel) {
  const test::ScratchFolder folder;
  keep_load_series(folder.path());
  EXPECT_TRUE(read_load_series(folder.path(), 0).end.empty());
}

/// Load 2 t along the course, as steps of h give its impulses, from 1 s to 3 s.
LoadSeries ramp(double h) {
  LoadSeries series;
  series.start = 1;
  for (int k = 1; k <= std::lround(2 / h); ++k) {
    series.end.push_back(1 + k * h);
    series.loads[0].push_back(2 * (1 + (k - 0.5) * h));
    series.loads[1].push_back(-1);
  }
  return series;
}

TEST(LoadSeries, HasOneMeanOverAWindowWhateverTheSteps) {
  for (const double h : {0.5, 0.25, 0.1}) EXPECT_NEAR(statistics_over(ramp(h), 0, 1.5, 3).mean, 4.5, 1e-12) << h;
  // a step that lies half inside counts half: 2.5 s to 3 s at 5.5 N, of 2 s to 2.5 s at 4.5 N the second half
  EXPECT_NEAR(statistics_over(ramp(0.5), 0, 2.25, 3).mean, (5.5 * 0.5 + 4.5 * 0.25) / 0.75, 1e-12);
  EXPECT_NEAR(statistics_over(ramp(0.5), 1, 1, 3).std, 0, 1e-12);
  EXPECT_NEAR(statistics_over(ramp(0.5), 0, 1, 2).max, 3.5, 1e-12);
}

TEST(LoadSeries, IsNotKnownWhereTheRunHasNoStep) {
  EXPECT_TRUE(std::isnan(statistics_over(ramp(0.5), 0, 3, 4).mean));
  EXPECT_TRUE(std::isnan(statistics_over(LoadSeries{}, 0, 0, 1).p99));
}

}  // namespace load_series_test
