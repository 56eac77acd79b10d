#include "hydro/radiation/damping.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/hydro/radiation/radiation_cases.h"

namespace nilas::hydro::damping_test {

using radiation_cases::closed_database;

std::string refusal(const Database& database) {
  try {
    prepare_damping(database);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Damping, IsKeptAtTheFilesFrequencies) {
  const Database database = closed_database();
  const RadiationDamping damping = prepare_damping(database);
  EXPECT_TRUE(damping.report.notes.empty());
  EXPECT_EQ(damping.report.negative, 0);
  for (std::size_t k = 0; k < database.frequency.size(); k += 37) {
    const VecX row = damping.scaled(database.frequency[k]);
    const Mat6 B = damping.scale.asDiagonal() * Eigen::Map<const Mat6>(row.data()) * damping.scale.asDiagonal();
    EXPECT_LT((B - database.damping[k]).cwiseAbs().maxCoeff(), 1e-9 * 2500);
  }
}

/// A single negative value near the peak, as an irregular frequency makes it: set to zero and reported.
TEST(Damping, ThatIsNegativeAtOneFrequencyIsRepaired) {
  Database database = closed_database();
  database.damping[20](2, 2) = -50;
  const RadiationDamping damping = prepare_damping(database);
  EXPECT_EQ(damping.report.negative, 1);
  EXPECT_DOUBLE_EQ(damping.report.lowest_frequency, database.frequency[20]);
  ASSERT_EQ(damping.report.notes.size(), 1);
  EXPECT_NE(damping.report.notes[0].find("heave is negative at 1 used frequencies"), std::string::npos)
      << damping.report.notes[0];
  EXPECT_NEAR(damping.scaled(database.frequency[20])[2 + 6 * 2], 0, 1e-15);
}

/// As WEC-Sim's sphere at 8.40 rad/s: short waves that the panels do not resolve. The file is cut there.
TEST(Damping, ThatTurnsNegativeAtHighFrequencyIsCut) {
  Database database = closed_database();
  for (std::size_t k = 200; k < database.damping.size(); ++k)
    database.damping[k](2, 2) = -20.0 - static_cast<double>(k);
  const RadiationDamping damping = prepare_damping(database);
  EXPECT_EQ(damping.report.dropped, 200);
  EXPECT_DOUBLE_EQ(damping.report.last_frequency, database.frequency[199]);
  EXPECT_NE(damping.report.notes.at(0).find("not used"), std::string::npos);
}

TEST(Damping, ThatIsWrongIsRefused) {
  Database negative = closed_database();
  for (Mat6& B : negative.damping) B(2, 2) *= -1;
  EXPECT_NE(refusal(negative).find("the damping is negative"), std::string::npos) << refusal(negative);
  Database transposed = closed_database();
  for (Mat6& B : transposed.damping) B(0, 4) *= 0.5;
  EXPECT_NE(refusal(transposed).find("not symmetric"), std::string::npos) << refusal(transposed);
  Database none = closed_database();
  for (Mat6& B : none.damping) B.setZero();
  EXPECT_NE(refusal(none).find("no radiation damping"), std::string::npos);
  Database few = closed_database();
  few.frequency.resize(3);
  few.damping.resize(3);
  few.added_mass.resize(3);
  EXPECT_NE(refusal(few).find("at 3 frequencies"), std::string::npos);
}

TEST(Damping, SaysWhereItEndsTooEarly) {
  const RadiationDamping damping = prepare_damping(closed_database(), 2.0);
  EXPECT_DOUBLE_EQ(damping.report.last_frequency, 2.0);
  ASSERT_EQ(damping.report.notes.size(), 1);
  EXPECT_NE(damping.report.notes[0].find("still"), std::string::npos);
}

}  // namespace nilas::hydro::damping_test
