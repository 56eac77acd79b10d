#include "contact/law/cone.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/random_vectors.h"

namespace nilas::contact {
namespace cone_test {

constexpr double k_endless = std::numeric_limits<double>::infinity();

bool in_pyramid(const Vec3& x, double mu, int facets, double cap) {
  for (int k = 0; k < facets; ++k) {
    const double angle = (k + 0.5) * 2 * k_pi / facets;
    const double reach = std::cos(angle) * x[1] + std::sin(angle) * x[2];
    if (reach > mu * std::cos(k_pi / facets) * x[0] + 1e-12) return false;
  }
  return x[0] >= -1e-12 && x[0] <= cap + 1e-12;
}

/// A random member of the inscribed pyramid: a convex combination of corners at some height.
Vec3 random_member(RandomStream& random, double mu, int facets, double cap) {
  const double height = random.uniform(0, std::min(cap, 4.0));
  Vec2 t = Vec2::Zero();
  double total = 0;
  for (int k = 0; k < facets; ++k) {
    const double share = random.uniform();
    const double angle = 2 * k_pi * k / facets;
    t += share * Vec2(std::cos(angle), std::sin(angle));
    total += share;
  }
  const double stretch = random.uniform(0, 1);
  t *= mu * height * stretch / total;
  return {height, t.x(), t.y()};
}

/// Checks that y is the nearest point of a convex set to x. This holds iff y is a member and (x - y).(z - y) <= 0 for
/// every member z.
void expect_nearest(const Vec3& x, const Vec3& y, const Vec3& member) {
  EXPECT_LE((x - y).dot(member - y), 1e-12 * (1 + x.squaredNorm()));
}

TEST(Cone, HandWorkedPoints) {
  EXPECT_EQ(project_cone({2, 0.6, -0.8}, 0.5), Vec3(2, 0.6, -0.8));
  EXPECT_EQ(project_cone({-2, 0.6, -0.8}, 0.5), Vec3::Zero());
  // n = 0, |t| = 2, mu = 0.5: height (0 + 1)/1.25 = 0.8
  EXPECT_LT((project_cone({0, 1.2, 1.6}, 0.5) - Vec3(0.8, 0.24, 0.32)).norm(), 1e-15);
  // mu = 2: height (1 + 2*7)/5 = 3, radius 6
  EXPECT_LT((project_cone({1, 0, 7}, 2) - Vec3(3, 0, 6)).norm(), 1e-14);
}

TEST(Cone, ZeroAndInfiniteFriction) {
  EXPECT_EQ(project_cone({3, 1, 2}, 0), Vec3(3, 0, 0));
  EXPECT_EQ(project_cone({-3, 1, 2}, 0), Vec3::Zero());
  EXPECT_EQ(project_cone({3, 1, 2}, k_endless), Vec3(3, 1, 2));
  EXPECT_EQ(project_cone({-3, 3, 4}, k_endless), Vec3(0, 3, 4));
  EXPECT_EQ(project_cone({-3, 0, 0}, k_endless), Vec3::Zero());
  EXPECT_LT((project_cone({-3, 3, 4}, 1e12) - Vec3(0, 3, 4)).norm(), 1e-11);
}

TEST(Cone, NearestPointOfTheTruncatedConeByItsVariationalInequality) {
  RandomStream random(1, "cone");
  for (int k = 0; k < 4000; ++k) {
    const double mu = k % 7 == 0 ? 0 : std::exp(random.normal());
    const double cap = k % 3 == 0 ? k_endless : random.uniform(0, 2);
    const Vec3 x = 3 * test::random_vector(random);
    const Vec3 y = project_cone(x, mu, cap);
    ASSERT_LE(tangential_norm(y), mu * y[0] + 1e-12);
    ASSERT_LE(y[0], cap);
    for (int j = 0; j < 20; ++j) {
      const double height = random.uniform(0, std::min(cap, 4.0)), angle = random.uniform(0, 2 * k_pi);
      const double radius = mu * height * (j % 2 == 0 ? 1 : random.uniform());
      expect_nearest(x, y, {height, radius * std::cos(angle), radius * std::sin(angle)});
    }
    expect_nearest(x, y, Vec3::Zero());
  }
}

TEST(Cone, TruncatedToNothing) {
  EXPECT_EQ(project_cone({5, 1, 1}, 0.5, 0), Vec3::Zero());
  EXPECT_EQ(project_pyramid({5, 1, 1}, 0.5, 8, 0), Vec3::Zero());
}

TEST(Cone, NearestPointOfThePyramidByItsVariationalInequality) {
  RandomStream random(2, "pyramid");
  for (int k = 0; k < 4000; ++k) {
    const int facets = 3 + k % 10;
    const double mu = std::exp(random.normal());
    const double cap = k % 3 == 0 ? k_endless : random.uniform(0, 2);
    const Vec3 x = 3 * test::random_vector(random);
    const Vec3 y = project_pyramid(x, mu, facets, cap);
    ASSERT_TRUE(in_pyramid(y, mu, facets, cap)) << facets << " " << x.transpose() << " -> " << y.transpose();
    for (int j = 0; j < 20; ++j) expect_nearest(x, y, random_member(random, mu, facets, cap));
    for (int corner = 0; corner < facets; ++corner) {
      const double angle = 2 * k_pi * corner / facets, height = std::min(cap, 3.0);
      expect_nearest(x, y, {height, mu * height * std::cos(angle), mu * height * std::sin(angle)});
    }
    expect_nearest(x, y, Vec3::Zero());
  }
}

TEST(Cone, PyramidOfManyFacetsIsTheCone) {
  // nearest points differ by at most half a facet at the cap, mu cap sin(pi/k)
  RandomStream random(3, "limit");
  for (const int facets : {10, 100, 1000})
    for (int k = 0; k < 200; ++k) {
      const Vec3 x = test::random_vector(random);
      const double difference = (project_pyramid(x, 0.7, facets, 1.0) - project_cone(x, 0.7, 1.0)).norm();
      EXPECT_LT(difference, 0.7 * std::sin(k_pi / facets));
    }
}

TEST(Cone, PyramidSupportIsTheLargestCornerProduct) {
  RandomStream random(4, "support");
  for (int facets = 3; facets < 12; ++facets)
    for (int k = 0; k < 50; ++k) {
      const double x = random.normal(), y = random.normal();
      double largest = -k_endless;
      for (int corner = 0; corner < facets; ++corner) {
        const double angle = 2 * k_pi * corner / facets;
        largest = std::max(largest, std::cos(angle) * x + std::sin(angle) * y);
      }
      EXPECT_NEAR(pyramid_support({x, y}, facets), largest, 1e-14);
    }
}

TEST(Cone, WithoutFrictionNothingBelowTheTipIsInside) {
  EXPECT_EQ(project_cone(Vec3(-2, 0, 0), 0), Vec3(Vec3::Zero()));
  EXPECT_EQ(project_cone(Vec3(-2, 0, 0), 0, 5), Vec3(Vec3::Zero()));
  EXPECT_EQ(project_pyramid(Vec3(-2, 0, 0), 0, 8, 5), Vec3(Vec3::Zero()));
}

}  // namespace cone_test
}  // namespace nilas::contact
