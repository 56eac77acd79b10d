#include "hydro/radiation/retardation.h"

#include <gtest/gtest.h>

#include "tests/hydro/radiation/radiation_cases.h"

namespace nilas::hydro::retardation_test {

using radiation_cases::closed_database;
using radiation_cases::closed_matrix;
using radiation_cases::closed_retardation;
using radiation_cases::sphere_database;

/// Spacing 0.05 rad/s of a function of unit width: the spline errs by about 0.05^4 / 384 times a fourth derivative of
/// order 100, so 1e-6. Beyond 20 rad/s lies 9 w^-4, whose fitted tail is exact to 2 %: (2 / pi) 3 / 20^3 2 % = 5e-6.
TEST(Retardation, IsTheClosedFormOfARationalFunction) {
  const RadiationDamping damping = prepare_damping(closed_database());
  EXPECT_NEAR(damping.report.tail_power, 4, 0.05);
  ASSERT_EQ(damping.groups, (std::vector<std::vector<int>>{{0, 4}, {2}}));
  const Retardation kernel = retardation(damping);
  EXPECT_LE(kernel.left, 1e-3);
  double integral = 0;
  for (std::size_t k = 0; k < kernel.K.size(); ++k) {
    const double t = kernel.step * static_cast<double>(k);
    EXPECT_LT((kernel.K[k] - closed_retardation(t) * closed_matrix()).cwiseAbs().maxCoeff(), 2500 * 3e-5) << t;
    if (k > 0) integral += 0.5 * kernel.step * (kernel.K[k - 1](2, 2) + kernel.K[k](2, 2));
  }
  EXPECT_NEAR(kernel.K1.back()(2, 2), integral, 1000 * 1e-3);  // the trapezium errs by step^2 / 12 times K'
}

/// Ogilvie's relation: A(w) of the same function. The largest error is that of the lowest frequency, where the spline
/// does not know the curvature that B ~ 0.75 w^2 has at zero, and 1 / w enlarges it.
TEST(Retardation, AgreesWithTheAddedMass) {
  Database database = closed_database();
  const RadiationDamping damping = prepare_damping(database);
  const Retardation kernel = retardation(damping);
  const InfiniteAddedMass of_file = infinite_added_mass(database, damping, kernel);
  EXPECT_TRUE(of_file.from_file);
  EXPECT_LT(of_file.root_mean_square, 1e-4);
  EXPECT_LT(of_file.worst, 1e-3);
  database.added_mass_infinite.reset();
  const InfiniteAddedMass found = infinite_added_mass(database, damping, kernel);
  EXPECT_FALSE(found.from_file);
  EXPECT_LT((found.value - 5000 * Mat6::Identity()).cwiseAbs().maxCoeff(), 0.5);
}

/// The figures of the file: it agrees with Ogilvie's relation to 0.25 % (root mean square) of its largest added mass.
/// The worst place lies at high frequency, where its panels do not resolve the waves.
TEST(Retardation, OfTheSphereAgreesWithItsAddedMass) {
  Database database = sphere_database();
  const RadiationDamping damping = prepare_damping(database);
  // The rotations of a sphere radiate nothing.
  ASSERT_EQ(damping.groups, (std::vector<std::vector<int>>{{0}, {1}, {2}}));
  const Retardation kernel = retardation(damping);
  EXPECT_LE(kernel.left, 1e-3);
  EXPECT_GT(kernel.memory, 8);
  EXPECT_LT(kernel.memory, 20);
  const InfiniteAddedMass of_file = infinite_added_mass(database, damping, kernel);
  EXPECT_TRUE(of_file.from_file);
  EXPECT_LT(of_file.root_mean_square, 3e-3);
  const double given = (*database.added_mass_infinite)(2, 2);
  database.added_mass_infinite.reset();
  EXPECT_NEAR(infinite_added_mass(database, damping, kernel).value(2, 2), given, 1e-3 * given);
}

TEST(Retardation, SaysWhatTheMemoryLeavesOut) {
  const RadiationDamping damping = prepare_damping(closed_database());
  EXPECT_NEAR(damping.longest_memory, k_pi / 0.05, 1e-9);
  EXPECT_DOUBLE_EQ(retardation(damping, 5.0).memory, 5);
  EXPECT_GT(retardation(damping, 5.0).left, 1e-2);
  EXPECT_LT(retardation(damping).unresolved, 1e-3);
  // Every tenth frequency: a spacing of 0.5 rad/s resolves 2 pi seconds.
  Database coarse = closed_database();
  for (std::size_t k = 0; 10 * k + 9 < coarse.frequency.size(); ++k) {
    coarse.frequency[k] = coarse.frequency[10 * k + 9];
    coarse.damping[k] = coarse.damping[10 * k + 9];
    coarse.added_mass[k] = coarse.added_mass[10 * k + 9];
  }
  coarse.frequency.resize(40);
  coarse.damping.resize(40);
  coarse.added_mass.resize(40);
  const RadiationDamping rough = prepare_damping(coarse);
  EXPECT_NEAR(rough.longest_memory, 2 * k_pi, 1e-9);
  EXPECT_GT(retardation(rough).unresolved, 0.01);
}

}  // namespace nilas::hydro::retardation_test
