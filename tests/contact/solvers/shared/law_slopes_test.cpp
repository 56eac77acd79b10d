#include "contact/solvers/shared/law_slopes.h"

#include <gtest/gtest.h>

#include <limits>

#include "contact/law/law_map.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::solvers {
namespace law_slopes_test {

constexpr double k_no_cap = std::numeric_limits<double>::infinity();
constexpr Law k_laws[] = {Law::coulomb, Law::ccp, Law::pyramid, Law::pyramid_k, Law::frictionless};
constexpr int k_facets = 6;

Vec3 value(Law law, double mu, double cap, const Vec3& r, const Vec3& u) {
  return law_slopes(law, k_facets, mu, cap, r, u).value;
}

TEST(LawSlopes, AreTheDerivativesOfTheValue) {
  constexpr double step = 1e-7;
  RandomStream random(3, "slopes");
  for (const Law law : k_laws)
    for (const double mu : {0.0, 0.3, 2.0})
      for (const double cap : {k_no_cap, 0.7})
        for (int k = 0; k < 200; ++k) {
          const Vec3 r = test::random_vector(random), u = test::random_vector(random);
          const LawSlopes slopes = law_slopes(law, k_facets, mu, cap, r, u);
          int wrong = 0;
          for (int i = 0; i < 3; ++i) {
            const Vec3 d = step * Vec3::Unit(i);
            const Vec3 by_r = (value(law, mu, cap, r + d, u) - value(law, mu, cap, r - d, u)) / (2 * step);
            const Vec3 by_u = (value(law, mu, cap, r, u + d) - value(law, mu, cap, r, u - d)) / (2 * step);
            wrong += (by_r - slopes.by_impulse.col(i)).norm() > 1e-6;
            wrong += (by_u - slopes.by_velocity.col(i)).norm() > 1e-6;
          }
          EXPECT_EQ(wrong, 0) << static_cast<int>(law) << " mu " << mu << " cap " << cap << " r " << r.transpose()
                              << " u " << u.transpose();
        }
}

TEST(LawSlopes, VanishWhereTheLawHolds) {
  // impulse, velocity: open, sticking, sliding along t1, and at the force limit
  const contact::ContactScale scale{0.5, 2, 1};
  const struct {
    Vec3 r, u;
  } states[] = {
      {{0, 0, 0}, {0.3, 1, -2}}, {{1, 0.2, 0.1}, {0, 0, 0}}, {{1, -0.5, 0}, {0, 3, 0}}, {{2, 0.1, 0}, {-1, 0, 0}}};
  for (const auto& state : states)
    for (const Law law : {Law::coulomb, Law::pyramid, Law::pyramid_k}) {
      EXPECT_LT(contact::law_map(law, k_facets, scale, state.r, state.u), 1e-15);
      EXPECT_LT(value(law, scale.mu, scale.force_limit, state.r, state.u).norm(), 1e-15) << static_cast<int>(law);
    }
}

TEST(LawSlopes, OpenMeansThatVelocityDoesNotMatter) {
  RandomStream random(5, "open");
  for (const Law law : k_laws)
    for (int k = 0; k < 200; ++k) {
      const Vec3 r = test::random_vector(random), u = test::random_vector(random);
      const LawSlopes slopes = law_slopes(law, k_facets, 0.4, k_no_cap, r, u);
      if (!slopes.open) continue;
      EXPECT_EQ(slopes.value, r);
      EXPECT_TRUE(slopes.by_velocity.isZero(0));
      EXPECT_TRUE(slopes.by_impulse.isIdentity(0));
    }
}

}  // namespace law_slopes_test
}  // namespace nilas::solvers
