#include "contact/solvers/bodies/cone_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/solvers/shared/second_order_cone.h"
#include "core/base/random.h"

namespace nilas::solvers {
namespace cone_pairs_test {

constexpr std::size_t k_count = 60;
constexpr ContactRange k_all{0, k_count};

/// Points inside the cone, some of them near its side and some on its axis.
ContactVectors points(std::uint64_t seed) {
  RandomStream random(seed, "points");
  ContactVectors out(k_count);
  for (std::size_t c = 0; c < k_count; ++c) {
    const Vec2 t = c % 7 == 0 ? Vec2(Vec2::Zero()) : Vec2(random.normal(), random.normal());
    out.set(c, {t.norm() + (c % 5 == 0 ? 1e-9 : 1) * (0.1 + random.uniform()), t[0], t[1]});
  }
  return out;
}

ContactVectors directions(std::uint64_t seed) {
  RandomStream random(seed, "directions");
  ContactVectors out(k_count);
  for (std::size_t c = 0; c < k_count; ++c) out.set(c, {random.normal(), random.normal(), random.normal()});
  return out;
}

/// The scaling of this file maps y to l, that of second_order_cone.h maps x: T is its inverse.
TEST(ConePairs, ScaleAsOneConeIsScaled) {
  const ContactVectors x = points(1), y = points(2), a = directions(3), g = directions(4);
  ConeScaling scaling(k_count);
  ASSERT_TRUE(scale(x, y, scaling, k_all));
  ContactVectors dual(k_count), primal(k_count);
  from_dual(scaling, g, a, dual, k_all);
  to_primal(scaling, g, a, primal, k_all);
  for (std::size_t c = 0; c < k_count; ++c) {
    const NesterovTodd nt = nesterov_todd(x.at(c), y.at(c));
    const Mat3 t = nt.inverse;
    const double size = t.norm() * (1 + t.norm());
    EXPECT_LT((scaling.scaled.at(c) - nt.scaled).norm(), 1e-6 * nt.scaled.norm()) << c;
    EXPECT_LT((dual.at(c) - t * (g.at(c) + t * a.at(c))).norm(), 1e-6 * size) << c;
    EXPECT_LT((primal.at(c) - t * (g.at(c) - t * a.at(c))).norm(), 1e-6 * size) << c;
    EXPECT_NEAR(scaling.squared.entry[0][c], (t * t)(0, 0), 1e-6 * t.squaredNorm()) << c;
    EXPECT_NEAR(scaling.squared.entry[4][c], (t * t)(2, 1), 1e-6 * t.squaredNorm()) << c;
  }
}

TEST(ConePairs, RightSidesAreThoseOfTheAlgebra) {
  const ContactVectors x = points(1), y = points(2), dx = directions(5), dy = directions(6);
  ConeScaling scaling(k_count);
  ASSERT_TRUE(scale(x, y, scaling, k_all));
  ContactVectors g(k_count);
  constexpr double target = 0.3;
  corrected(scaling, dx, dy, target, g, k_all);
  for (std::size_t c = 1; c < k_count; ++c) {
    if (c % 5 == 0) continue;  // near the side of the cone both lose digits
    const NesterovTodd nt = nesterov_todd(x.at(c), y.at(c));
    const Vec3 l = nt.scaled;
    const Vec3 wanted =
        target * Vec3::UnitX() - jordan_product(l, l) - jordan_product(nt.scaling * dx.at(c), nt.inverse * dy.at(c));
    EXPECT_LT((g.at(c) - jordan_quotient(wanted, l)).norm(), 1e-8 * (1 + g.at(c).norm())) << c;
  }
}

TEST(ConePairs, LongestStepIsThatOfTheNearestCone) {
  const ContactVectors x = points(1), dx = directions(7);
  double expected = 1;
  for (std::size_t c = 0; c < k_count; ++c) expected = std::min(expected, step_to_boundary(x.at(c), dx.at(c)));
  EXPECT_NEAR(longest_step(x, dx, k_all), expected, 1e-9 * expected);
  ContactVectors line(1), back(1);
  line.set(0, {2, 0, 0});
  back.set(0, {-3, 0, 0});
  EXPECT_NEAR(longest_step(line, back, {0, 1}), 2.0 / 3, 1e-12);
}

TEST(ConePairs, RefusesPointsOutsideAndWhatIsNoNumber) {
  for (const Vec3& bad : {Vec3(1, 5, 0), Vec3(-1, 0, 0), Vec3(std::nan(""), 0, 0)}) {
    ContactVectors x = points(1), y = points(2);
    ConeScaling scaling(k_count);
    x.set(3, bad);
    EXPECT_FALSE(scale(x, y, scaling, k_all));
    std::swap(x, y);
    EXPECT_FALSE(scale(x, y, scaling, k_all));
  }
}

}  // namespace cone_pairs_test
}  // namespace nilas::solvers
