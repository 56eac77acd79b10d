/// Tests of the map of extremes: its cheap cases, and that a broken limit is detected.
#include "apps/verify/extremes.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace extremes_test {

using namespace nilas;
using namespace nilas::verify;

TEST(Extremes, TheDefaultSolverHoldsOrSaysThatItStopped) {
  Selection some;
  some.cases = {"mass ratio",    "friction", "thickness", "aspect", "speed",
                "shortest edge", "offset",   "pitch",     "overlap"};
  some.solvers = {"auto"};
  const auto cells = run_extremes(some, 2, {});
  EXPECT_GE(cells.size(), 50u);
  for (const auto& cell : cells)
    EXPECT_STREQ(to_string(cell.hold), "holds")
        << cell.extreme << " " << cell.level << " " << cell.model.integrator << ": won " << cell.energy_won
        << ", momentum " << cell.momentum_error << ", penetration " << cell.penetration << ", drift " << cell.drift
        << " " << cell.message;
}

TEST(Extremes, SweepsAreShortOfGreatMassRatiosAndSaySo) {
  Selection some;
  some.cases = {"mass ratio"};
  some.solvers = {"nsgs"};
  const auto cells = run_extremes(some, 2, {});
  EXPECT_STREQ(to_string(cells.front().hold), "holds");
  EXPECT_STREQ(to_string(cells.back().hold), "short");
  EXPECT_GT(cells.back().short_steps, 0);
  EXPECT_NE(extremes_csv(cells).find("mass ratio\",1e+08,nsgs,moreau,short"), std::string::npos);
}

TEST(Extremes, UnknownNamesAreRefused) { EXPECT_THROW(run_extremes({{"mass"}, {}, {}}, 1, {}), InputError); }

}  // namespace extremes_test
