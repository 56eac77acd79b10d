/// Motions from a database against the motions of its own file .4, which WAMIT computed from the same matrices.
#include "hydro/database/response.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "core/base/error.h"
#include "tests/hydro/database/data_files.h"
#include "tests/support/refusal.h"

namespace response_test {

using namespace nilas;
using namespace nilas::hydro;

/// The largest difference in heave over all headings, at periods from `shortest` on.
double heave_error(const Database& database, double shortest) {
  const auto motions = responses(database, test::fpso_mass());
  double worst = 0;
  for (std::size_t k = 0; k < motions.size(); ++k)
    for (std::size_t h = 0; h < motions[k].size(); ++h)
      if (2 * k_pi / database.frequency[k] >= shortest)
        worst = std::max(worst, std::abs(motions[k][h][2] - database.motion[k][h][2]));
  return worst;
}

/// 58 periods were computed, of which the file keeps those of 2 s and above, and 19 headings.
TEST(Response, HeaveOfTheFpsoIsThatOfItsFileForAllHeadings) {
  const Database database = test::fpso();
  ASSERT_EQ(database.heading.size(), 19u);
  EXPECT_LT(heave_error(database, 6.5), 1.3e-3);
  EXPECT_LT(heave_error(database, 20), 1e-4);
}

/// In the range where the panels are fine for the wave, all modes close within half a hundredth of their largest
/// motion.
TEST(Response, AllModesOfTheFpsoClose) {
  const Database database = test::fpso();
  const auto motions = responses(database, test::fpso_mass());
  Vec6 largest = Vec6::Zero(), worst = Vec6::Zero();
  for (std::size_t k = 0; k < motions.size(); ++k)
    for (std::size_t h = 0; h < motions[k].size(); ++h) {
      if (2 * k_pi / database.frequency[k] < 6.5) continue;
      largest = largest.cwiseMax(database.motion[k][h].cwiseAbs());
      worst = worst.cwiseMax((motions[k][h] - database.motion[k][h]).cwiseAbs());
    }
  for (int i = 0; i < 6; ++i) EXPECT_LT(worst[i], 5e-3 * largest[i]) << "mode " << i + 1;
}

/// Each of these faults of a reader moves heave by more than the tolerance, by a factor of ten and more.
TEST(Response, WrongSignsPhasesAndScalesDoNotClose) {
  const Database right = test::fpso();
  const auto error_of = [&](const std::function<void(Database&)>& spoil) {
    Database wrong = right;
    spoil(wrong);
    return heave_error(wrong, 6.5);
  };
  const auto loads = [](Database& database, const std::function<void(ComplexVec6&)>& change) {
    for (auto& of_frequency : database.excitation)
      for (ComplexVec6& load : of_frequency) change(load);
  };
  EXPECT_GT(error_of([](Database& d) {
              for (Mat6& b : d.damping) b = -b;
            }),
            1.6);
  EXPECT_GT(error_of([&](Database& d) { loads(d, [](ComplexVec6& x) { x = x.conjugate().eval(); }); }), 0.1);
  EXPECT_GT(error_of([&](Database& d) { loads(d, [](ComplexVec6& x) { x *= std::complex<double>(0, 1); }); }), 0.1);
  EXPECT_GT(error_of([&](Database& d) { loads(d, [](ComplexVec6& x) { x[4] = -x[4]; }); }), 0.02);
  EXPECT_GT(error_of([](Database& d) {
              for (Mat6& a : d.added_mass) a *= 1.02;
            }),
            0.02);
}

/// A body without coupling: x = X / (C - w^2 (m + a) + i w b), by hand (3 - 4 * 2 + 2i * 0.5) x = 10.
TEST(Response, OneModeFollowsItsEquation) {
  const Mat6 one = Mat6::Identity();
  const ComplexVec6 x = response(2, 1.5 * one, 0.5 * one, 0.5 * one, 3 * one, ComplexVec6::Constant(10));
  const std::complex<double> expected = 10.0 / std::complex<double>(-5, 1);
  EXPECT_LT(std::abs(x[2] - expected), 1e-14);
}

/// The parallel axis theorem: a mass point at c has the inertia m (|c|^2 - c c') about the origin, so radii of gyration
/// about the axes are those of the components across.
TEST(Response, TheMassOfAPointMovesWithItsPlace) {
  const Vec3 c(1, 2, 3);
  const Mat6 mass = rigid_mass(4, c, {std::sqrt(13), std::sqrt(10), std::sqrt(5)});
  Vec6 twist;
  twist << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6;
  const Vec3 force = 4 * (twist.head<3>() + twist.tail<3>().cross(c));
  EXPECT_LT(((mass * twist).head<3>() - force).norm(), 1e-14);
  EXPECT_LT((mass - mass.transpose()).norm(), 1e-14);
}

TEST(Response, NeedsExcitationAndStiffness) {
  Database database = test::fpso();
  database.restoring.reset();
  test::expect_refusal([&] { responses(database, test::fpso_mass()); }, {"fpso.1", "no hydrostatic stiffness"});
  database.excitation.clear();
  test::expect_refusal([&] { responses(database, test::fpso_mass()); }, {"fpso.1", "no wave excitation"});
}

}  // namespace response_test
