/// A database at another scale: its matrices still give the same motions in the scaled wave.
#include "hydro/database/scaled_database.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/database/response.h"

namespace scaled_database_test {

using namespace nilas;
using namespace nilas::hydro;

Database small_ship() {
  Database database;
  database.density = 1025;
  database.gravity = 9.81;
  database.volume = 3.0;
  database.frequency = {1.5};
  Mat6 matrix = Mat6::Zero();
  matrix.diagonal() << 300, 2000, 2500, 400, 900, 700;
  matrix(1, 3) = matrix(3, 1) = 150;
  database.added_mass = {matrix};
  database.damping = {0.3 * matrix};
  database.restoring = Vec6(0, 0, 4e4, 3e3, 2e4, 0).asDiagonal();
  database.heading = {0};
  ComplexVec6 load;
  load << 100, std::complex<double>(20, 5), std::complex<double>(3e4, -900), 40, std::complex<double>(-7, 2000), 1;
  database.excitation = {{load}};
  return database;
}

/// Translations per metre of wave stay, rotations per metre go with 1 / lambda, at a frequency 1 / sqrt(lambda).
TEST(ScaledDatabase, MovesInTheSameWay) {
  const double lambda = 9;
  const Mat6 mass = rigid_mass(3075, Vec3(0.1, 0, -0.2), Vec3(0.4, 1.1, 1.1));
  const Mat6 large = rigid_mass(3075 * 729, lambda * Vec3(0.1, 0, -0.2), lambda * Vec3(0.4, 1.1, 1.1));
  const Database ship = small_ship(), big = scaled(small_ship(), lambda);
  EXPECT_DOUBLE_EQ(big.frequency[0], 0.5);
  EXPECT_DOUBLE_EQ(*big.volume, 3 * 729);
  const ComplexVec6 x = responses(ship, mass)[0][0];
  ComplexVec6 y = responses(big, large)[0][0];
  y.tail<3>() *= lambda;
  EXPECT_LT((x - y).norm(), 1e-12 * x.norm());
}

/// By 16 there and back, every number has the bits it had.
TEST(ScaledDatabase, ComesBackToTheSameBits) {
  const Database before = small_ship(), after = scaled(scaled(small_ship(), 16), 1.0 / 16);
  EXPECT_EQ(before.frequency, after.frequency);
  EXPECT_EQ(before.added_mass, after.added_mass);
  EXPECT_EQ(before.damping, after.damping);
  EXPECT_EQ(before.excitation, after.excitation);
  EXPECT_EQ(before.restoring, after.restoring);
}

}  // namespace scaled_database_test
