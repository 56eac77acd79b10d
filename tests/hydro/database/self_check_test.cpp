/// Checks of a database against itself, on real files and on files that were spoilt.
#include "hydro/database/self_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "hydro/database/wave_number.h"
#include "tests/hydro/database/data_files.h"
#include "tests/support/mentions.h"

namespace self_check_test {

using namespace nilas;
using namespace nilas::hydro;

/// The first sentence that is severe; empty where there is none.
std::string severe(const Database& database, const std::optional<Mat6>& mass = {}) {
  for (const Finding& finding : findings(database, check_database(database, mass)))
    if (finding.severe) return finding.text;
  return "";
}

void change_loads(Database& database, const std::function<void(ComplexVec6&)>& change) {
  for (auto& of_frequency : database.excitation)
    for (ComplexVec6& load : of_frequency) change(load);
}

const HaskindRatio& ratio_of(const SelfCheck& check, int mode) {
  return *std::find_if(check.haskind.begin(), check.haskind.end(),
                       [&](const HaskindRatio& ratio) { return ratio.mode == mode; });
}

/// The relation of Haskind and Newman holds in the FPSO's file within a thousandth in sway and heave.
TEST(SelfCheck, TheFpsoFitsTheRelationOfHaskindAndNewman) {
  const SelfCheck check = check_database(test::fpso(), test::fpso_mass());
  EXPECT_EQ(check.haskind.size(), 6u);
  for (const int mode : {1, 2}) {
    const HaskindRatio& ratio = ratio_of(check, mode);
    EXPECT_GT(ratio.frequencies, 10);
    EXPECT_GT(ratio.least, 0.998);
    EXPECT_LT(ratio.largest, 1.001);
  }
  EXPECT_EQ(severe(test::fpso(), test::fpso_mass()), "");
  EXPECT_NEAR(*check.long_wave->heave, 1, 0.01);
  EXPECT_NEAR(*check.long_wave->horizontal, 1, 0.01);
  ASSERT_EQ(check.closure.size(), 6u);
  for (const Closure& closure : check.closure) EXPECT_LT(closure.share, 5e-3);
}

/// In 50 m of water the relation needs the wave number and group velocity of that depth: without it the ratio is off by
/// a factor at long waves.
TEST(SelfCheck, TheRelationUsesTheDepth) {
  const Database database = test::sphere();
  const SelfCheck check = check_database(database);
  const HaskindRatio& ratio = ratio_of(check, 2);
  EXPECT_GT(ratio.least, 0.995);
  EXPECT_LT(ratio.largest, 1.001);
  Database deep = database;
  deep.depth.reset();
  EXPECT_LT(ratio_of(check_database(deep), 2).least, 0.5);
}

/// WEC-Sim's sphere has B33 / (rho w) = -0.2315 at w = 8.40 rad/s.
TEST(SelfCheck, NegativeDampingOfARealFileIsReported) {
  const SelfCheck check = check_database(test::sphere());
  ASSERT_FALSE(check.negative.empty());
  const NegativeDamping& worst = check.negative.back();
  EXPECT_EQ(worst.mode, 2);
  EXPECT_NEAR(worst.frequency, 8.40, 1e-3);
  EXPECT_NEAR(worst.value / (1000 * worst.frequency), -0.2315, 1e-3);
  EXPECT_TRUE(check.reversed.empty());
  bool told = false;
  for (const Finding& finding : findings(test::sphere(), check))
    told = told || (test::mentions(finding.text, "damping are negative") && test::mentions(finding.text, "heave"));
  EXPECT_TRUE(told);
}

/// Loads grow by one length more than damping, so ULEN = 2 instead of 1 gives twice the damping of the file.
TEST(SelfCheck, AWrongLengthIsRefused) {
  DatabaseSettings settings = test::fpso_settings();
  settings.length = 2;
  const std::string text = severe(read_database(test::fpso_file(), settings));
  EXPECT_TRUE(test::mentions(text, "2 in heave")) << text;
  EXPECT_TRUE(test::mentions(text, "ULEN")) << text;
}

/// A file that holds one triangle only.
TEST(SelfCheck, AMatrixThatIsNotSymmetricIsRefused) {
  Database triangle = test::fpso();
  for (Mat6& a : triangle.added_mass) a = Mat6(a.triangularView<Eigen::Upper>());
  const std::string text = severe(triangle);
  EXPECT_TRUE(test::mentions(text, "not symmetric")) << text;
  EXPECT_TRUE(test::mentions(text, "one triangle")) << text;
}

/// A transposed coupling of modes: the damping of modes (i, j) at the place of (6 - i, 6 - j) is symmetric too, but
/// does not fit the excitation.
TEST(SelfCheck, ModesInAnotherOrderAreRefused) {
  Database database = test::fpso();
  for (Mat6& b : database.damping) b = Mat6(b.reverse());
  EXPECT_TRUE(test::mentions(severe(database), "Haskind")) << severe(database);
}

TEST(SelfCheck, ReversedDampingAndPhasesAreRefused) {
  Database damping = test::fpso();
  for (Mat6& b : damping.damping) b = -b;
  EXPECT_TRUE(test::mentions(severe(damping), "its sign is reversed")) << severe(damping);
  Database phases = test::fpso();
  change_loads(phases, [](ComplexVec6& x) { x = x.conjugate().eval(); });
  EXPECT_TRUE(test::mentions(severe(phases), "exp(-i w t)")) << severe(phases);
  Database stiff = test::fpso();
  *stiff.restoring *= 2;
  EXPECT_TRUE(test::mentions(severe(stiff), "Heave excitation of the longest wave")) << severe(stiff);
}

/// A mass that is not that of the file does not close.
TEST(SelfCheck, AnotherMassDoesNotClose) {
  const std::string text = severe(test::fpso(), Mat6(1.2 * test::fpso_mass()));
  EXPECT_TRUE(test::mentions(text, "motion in")) << text;
}

/// HydroChrono's sphere.h5 states a depth of 200 m, but its longest wave has the loads of deep water.
TEST(SelfCheck, TheDepthOfHydroChronosSphereIsDoubted) {
  const Database stated = read_database(test::k_hydro_data / "hydrochrono/sphere.h5");
  EXPECT_NEAR(*check_database(stated).long_wave->horizontal, 0.224, 0.01);
  DatabaseSettings settings;
  settings.depth = std::numeric_limits<double>::infinity();
  const Database deep = read_database(test::k_hydro_data / "hydrochrono/sphere.h5", settings);
  EXPECT_NEAR(*check_database(deep).long_wave->horizontal, 1, 0.01);
}

/// Headings of a quarter of the circle cannot be integrated, and a single one only for a round body.
TEST(SelfCheck, SaysWhyTheRelationWasNotTested) {
  Database database = test::fpso();
  database.heading.resize(4);
  for (auto& of_frequency : database.excitation) of_frequency.resize(4);
  EXPECT_TRUE(test::mentions(check_database(database).no_haskind, "circle"));
  EXPECT_TRUE(test::mentions(check_database(database).no_closure, "mass"));
}

/// Heave of the sphere in its range: w^2 (m + A(w)) = C, by hand at A = 1.42e5 kg: 2 pi sqrt((261.8e3 + 1.1e5)
/// / 7.70e5) is near 4.4 s, as its decay shows.
TEST(NaturalModes, FollowTheAddedMassOfTheirOwnFrequency) {
  const Database database = test::sphere();
  const Mat6 mass = rigid_mass(261.8e3, {0, 0, -2}, {3, 3, 3});
  const auto modes = natural_modes(database, mass);
  ASSERT_EQ(modes.size(), 3u);
  EXPECT_EQ(modes.front().mode, 2);
  const double w = 2 * k_pi / modes.front().period;
  EXPECT_NEAR(w * w * (261.8e3 + added_mass_at(database, w)(2, 2)), (*database.restoring)(2, 2), 1e-6 * 7.7e5);
  EXPECT_NEAR(modes.front().period, 4.37, 0.02);
}

/// w^2 = g k tanh(k h), and the group velocity is its derivative.
TEST(WaveNumber, SolvesTheDispersionRelation) {
  for (const double w : {0.02, 0.3, 1.0, 4.0, 20.0}) {
    const double k = wave_number(w, 9.81, 50);
    EXPECT_NEAR(9.81 * k * std::tanh(50 * k), w * w, 1e-13 * w * w);
    const double step = 1e-5 * w;
    const double slope = 2 * step / (wave_number(w + step, 9.81, 50) - wave_number(w - step, 9.81, 50));
    EXPECT_NEAR(group_velocity(w, 9.81, 50), slope, 1e-6 * slope);
  }
  EXPECT_EQ(wave_number(2, 10, {}), 0.4);
  EXPECT_EQ(group_velocity(2, 10, {}), 2.5);
}

}  // namespace self_check_test
