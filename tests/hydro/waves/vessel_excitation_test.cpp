#include "hydro/waves/vessel_excitation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "hydro/database/heading_circle.h"
#include "tests/hydro/waves/synthetic_database.h"

namespace vessel_excitation_test {

using namespace nilas;
using namespace nilas::hydro;
using test::synthetic_database;

constexpr double k_gravity = 9.81;

WaveTrain regular(double amplitude, double frequency, double heading, double phase = 0) {
  WaveTrain train;
  train.height = 2 * amplitude;
  train.period = 2 * k_pi / frequency;
  train.heading = heading;
  train.phase = phase;
  return train;
}

Vec6 load_of(const Database& database, const std::vector<WaveTrain>& trains, double t, double yaw = 0,
             WaveDrift drift = WaveDrift::none, const Vec2& x = Vec2::Zero()) {
  const WaveField field(trains, k_gravity, 0, 0, 1);
  const VesselExcitation excitation(database, field, drift);
  return excitation.load(field, WaveColumn(field, x, t), yaw, t);
}

/// Frequencies and headings of the database give its own values, within rounding: Re(X a exp(i w t)).
TEST(VesselExcitation, IsExactAtTheValuesOfTheDatabase) {
  const Database database = synthetic_database();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < database.heading.size(); ++k) {
      const double t = 0.7, w = database.frequency[i];
      const Vec6 load = load_of(database, {regular(0.3, w, database.heading[k])}, t);
      const Vec6 expected = (0.3 * std::polar(1.0, w * t) * database.excitation[i][k]).real();
      EXPECT_LT((load - expected).norm(), 1e-12 * 500) << i << " " << k;
    }
}

/// Half way between two frequencies and two headings: the mean of the four complex values.
TEST(VesselExcitation, InterpolatesComplexValues) {
  const Database database = synthetic_database();
  const auto& x = database.excitation;
  const ComplexVec6 mean = 0.25 * (x[0][1] + x[0][2] + x[1][1] + x[1][2]);
  const double heading = 0.5 * (database.heading[1] + database.heading[2]), t = 1.1;
  const Vec6 load = load_of(database, {regular(1, 0.75, heading)}, t);
  EXPECT_LT((load - (std::polar(1.0, 0.75 * t) * mean).real()).norm(), 1e-9);
}

/// Waves from port and starboard: surge, heave and pitch are the same, sway, roll and yaw change sign.
TEST(VesselExcitation, MirrorsWavesFromTheOtherSide) {
  for (const double heading : {0.2, 1.0, 2.5}) {
    const Vec6 port = load_of(synthetic_database(), {regular(1, 0.8, heading)}, 0.4, 0, WaveDrift::mean);
    const Vec6 starboard = load_of(synthetic_database(), {regular(1, 0.8, -heading)}, 0.4, 0, WaveDrift::mean);
    for (int mode = 0; mode < 6; ++mode)
      EXPECT_NEAR(starboard[mode], mode % 2 == 0 ? port[mode] : -port[mode], 1e-12) << mode;
  }
}

/// Only the heading relative to the vessel counts, and a vessel that is moved by x meets the phase of that place.
TEST(VesselExcitation, DependsOnRelativeHeadingAndPlace) {
  const Database database = synthetic_database();
  const Vec6 ahead = load_of(database, {regular(1, 0.8, 0.5)}, 0.4);
  EXPECT_LT((load_of(database, {regular(1, 0.8, 0.5 + 2.2)}, 0.4, 2.2) - ahead).norm(), 1e-9);
  const double k = 0.8 * 0.8 / k_gravity;
  const Vec6 moved = load_of(database, {regular(1, 0.8, 0)}, 0.4, 0, WaveDrift::none, {3, 5});
  EXPECT_LT((moved - load_of(database, {regular(1, 0.8, 0, -3 * k)}, 0.4)).norm(), 1e-9);
}

/// A regular wave pushes with a^2 D at all times, by both models.
TEST(VesselExcitation, ARegularWaveHasItsMeanDrift) {
  const Database database = synthetic_database();
  for (double t = 0; t < 6; t += 0.9) {
    const std::vector<WaveTrain> trains{regular(0.6, 1.0, database.heading[2])};
    const Vec6 first = load_of(database, trains, t);
    for (const WaveDrift drift : {WaveDrift::mean, WaveDrift::newman})
      EXPECT_LT((load_of(database, trains, t, 0, drift) - first - 0.36 * database.drift[1][2]).norm(), 1e-12);
  }
}

/// Two waves: the mean is the sum of both, and the slow part is 2 a1 a2 (D1 + D2) / 2 at the difference of frequencies.
TEST(VesselExcitation, NewmansApproximationBeatsAtTheDifference) {
  const Database database = synthetic_database();
  const std::vector<WaveTrain> trains{regular(0.6, 1.0, 0), regular(0.5, 1.5, 0)};
  const Vec6 d1 = database.drift[1][0], d2 = database.drift[2][0];
  for (double t = 0; t < 13; t += 0.9) {
    const Vec6 slow = load_of(database, trains, t, 0, WaveDrift::newman) - load_of(database, trains, t);
    const Vec6 mean = load_of(database, trains, t, 0, WaveDrift::mean) - load_of(database, trains, t);
    EXPECT_LT((mean - (0.36 * d1 + 0.25 * d2)).norm(), 1e-12);
    EXPECT_LT((slow - mean - 0.6 * 0.5 * (d1 + d2) * std::cos(0.5 * t)).norm(), 1e-12);
  }
}

std::string refusal(const Database& database, const std::vector<WaveTrain>& trains, double yaw,
                    WaveDrift drift = WaveDrift::none) {
  try {
    const WaveField field(trains, k_gravity, 0, 0, 1);
    VesselExcitation(database, field, drift).check_headings(field, yaw);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(VesselExcitation, RefusesWavesOutsideTheDatabase) {
  const Database whole = synthetic_database(), quarter = synthetic_database(0.5 * k_pi, 4);
  EXPECT_EQ(refusal(whole, {regular(1, 0.8, -2)}, 0), "");
  EXPECT_TRUE(has(refusal(whole, {regular(1, 1.6, 0)}, 0), "4.18879 to 12.5664 s"));
  EXPECT_TRUE(has(refusal(whole, {regular(1, 0.4, 0)}, 0), "found a wave with the period 15.708 s"));
  EXPECT_EQ(refusal(quarter, {regular(1, 0.8, 0.3)}, 0), "");
  EXPECT_EQ(refusal(quarter, {regular(1, 0.8, 0.3)}, 0.5), "");
  EXPECT_TRUE(has(refusal(quarter, {regular(1, 0.8, 0.3)}, -1.5), "-90 to 90 deg"));
  Database still = whole;
  still.drift.clear();
  EXPECT_TRUE(has(refusal(still, {regular(1, 0.8, 0)}, 0, WaveDrift::newman), "no mean drift"));
  still.excitation.clear();
  EXPECT_TRUE(has(refusal(still, {regular(1, 0.8, 0)}, 0), "no excitation"));
  Database shallow = whole;
  shallow.depth = 5;
  EXPECT_TRUE(has(refusal(shallow, {regular(1, 0.8, 0)}, 0), "set <waves depth>"));
}

TEST(VesselExcitation, StopsWhereTheVesselTurnsAwayFromTheDatabase) {
  EXPECT_THROW(load_of(synthetic_database(0.5 * k_pi, 4), {regular(1, 0.8, 0)}, 0, 2), SimulationError);
}

/// Headings that cover the circle wrap around; a list from 0 to 350 deg holds the gap before 360.
TEST(HeadingRange, CoversTheCircle) {
  std::vector<double> headings;
  for (int k = 0; k < 36; ++k) headings.push_back(10 * k * k_deg);
  const HeadingRange range(headings, {});
  const auto place = range.find(-4 * k_deg);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->before, 35u);
  EXPECT_EQ(place->after, 0u);
  EXPECT_NEAR(place->share, 0.6, 1e-12);
  EXPECT_EQ(range.find(2 * k_pi)->share, 0);
  headings.push_back(2 * k_pi);
  EXPECT_NEAR(HeadingRange(headings, {}).find(-4 * k_deg)->share, 0.6, 1e-12);
}

TEST(HeadingRange, MirrorsOnlyBodiesWithEqualSides) {
  const std::vector<double> half{0, 0.25 * k_pi, 0.5 * k_pi, 0.75 * k_pi, k_pi};
  const BodySymmetry equal{true, false};
  EXPECT_TRUE(HeadingRange(half, equal).find(-1)->mirror);
  EXPECT_FALSE(HeadingRange(half, equal).find(1)->mirror);
  EXPECT_FALSE(HeadingRange(half, {}).find(-1));
  EXPECT_EQ(HeadingRange(half, {}).text(), "0 to 180 deg");
  EXPECT_THROW(HeadingRange({}, {}), InputError);
  EXPECT_THROW(HeadingRange({1, 1}, {}), InputError);
}

/// Three or four headings are no circle: between them a straight line would lose up to 29 % of a cosine.
TEST(HeadingRange, HasNoValuesInWideGaps) {
  const HeadingRange four({0, 0.5 * k_pi, k_pi, 1.5 * k_pi}, {});
  for (const double heading : {0.0, 0.5 * k_pi, k_pi, -0.5 * k_pi}) {
    const auto place = four.find(heading);
    ASSERT_TRUE(place) << heading;
    EXPECT_LT(place->share * (1 - place->share), 1e-9);
  }
  for (const double heading : {0.3, 2.0, -2.0, -0.3}) EXPECT_FALSE(four.find(heading)) << heading;
  EXPECT_TRUE(has(four.text(), "0 to 270 deg, of which the widest gap is 90 deg")) << four.text();
  EXPECT_FALSE(HeadingRange({0, 2.0, 4.0}, {}).find(1));
  std::vector<double> eight;
  for (int k = 0; k < 8; ++k) eight.push_back(0.25 * k_pi * k);
  EXPECT_NEAR(HeadingRange(eight, {}).find(-0.125 * k_pi)->share, 0.5, 1e-12);
}

/// A hull with one side only, such as with a riser on it: added mass does not show it, damping or loads do.
TEST(VesselExcitation, MirrorsOnlyWhatIsAMirrorImage) {
  const auto refused = [](const Database& database) { return refusal(database, {regular(1, 0.8, -2)}, 0) != ""; };
  Database database = synthetic_database();
  EXPECT_FALSE(refused(database));
  for (auto& of_frequency : database.excitation) of_frequency[0][1] += 20;  // sway in waves from astern
  EXPECT_TRUE(refused(database));
  database = synthetic_database();
  for (std::size_t k = 0; k < database.frequency.size(); ++k) {
    database.damping.push_back(Mat6::Identity());
    database.damping.back()(0, 1) = database.damping.back()(1, 0) = 0.1;
  }
  EXPECT_TRUE(refused(database));
  // Both sides are given, and one of them is not the mirror image of the other.
  database = synthetic_database(2 * k_pi, 13);
  EXPECT_TRUE(is_symmetric_port_starboard(database));
  for (auto& of_frequency : database.excitation) of_frequency[2][2] *= 1.1;
  EXPECT_FALSE(is_symmetric_port_starboard(database));
}

/// The load of a wave from another direction on a round body is the known one, turned: surge of a wave ahead becomes
/// sway of a wave on the beam.
TEST(HeadingRange, TurnsTheLoadsOfRoundBodies) {
  const HeadingRange range({0}, {true, true});
  Vec6 known;
  known << 1, 2, 3, 4, 5, 6;
  const std::vector<Vec6> values{known};
  Vec6 expected;
  expected << -2, 1, 3, -5, 4, 6;
  EXPECT_LT((range.find(0.5 * k_pi)->of(values) - expected).norm(), 1e-14);
  EXPECT_EQ(range.find(0)->of(values), values[0]);
  EXPECT_FALSE(HeadingRange({0}, {}).find(1));
}

}  // namespace vessel_excitation_test
