/// Tests of one contact against closed forms, and against the natural map on random blocks.
#include "contact/law/local_solve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/random_vectors.h"

namespace nilas::contact {
namespace local_solve_test {

constexpr double k_none = std::numeric_limits<double>::infinity();
constexpr int k_facets = 8;

/// A block of two rigid bodies: 1/m I plus the terms of lever arms.
Mat3 rigid_block(RandomStream& random) {
  const Mat3 arm = skew(test::random_vector(random));
  const Vec3 moments(random.uniform(0.5, 1.5), random.uniform(0.5, 1.5), random.uniform(0.5, 1.5));
  const Mat3 turning = arm.transpose() * moments.asDiagonal() * arm;
  return Mat3::Identity() + 0.5 * (turning + turning.transpose());
}

Mat3 gram(RandomStream& random, int rank) {
  Mat3 sum = Mat3::Zero();
  for (int k = 0; k < rank; ++k) {
    const Vec3 x = test::random_vector(random);
    sum += x * x.transpose();
  }
  return sum;
}

/// The law's residual of the solution over (1 + mu) |b| + d |r|, since u_hat contains mu |u_T|.
double miss(Law law, const Mat3& w, const Vec3& b, double mu, double limit, double compliance, double tangential) {
  ContactStart start;
  const Vec3 r = solve_contact(law, k_facets, ContactBlock(w, mu, limit, compliance, tangential), b, start);
  const double d = w.trace() / 3;
  const Vec3 u = compliant_velocity(compliance, tangential, r, w * r + b);
  return law_map(law, k_facets, {mu, limit, d}, r, u) /
         ((1 + mu) * b.norm() + (d + compliance + tangential) * r.norm());
}

class EveryLaw : public testing::TestWithParam<Law> {
 protected:
  /// The largest residual over random velocities, frictions, limits and compliances.
  template <class MakeBlock>
  double worst(const MakeBlock& make_block, int count = 3000) const {
    RandomStream random(7, "blocks");
    double largest = 0;
    for (int k = 0; k < count; ++k) {
      const Mat3 w = make_block(random);
      const double mu = k % 9 == 0 ? 0 : std::exp(random.normal() - 1);
      const double limit = k % 3 == 0 ? std::exp(random.normal()) : k_none;
      const double compliance = k % 5 == 0 ? random.uniform(0, 0.1) : 0;
      const double tangential = k % 10 == 0 ? 2 * compliance : 0;
      Vec3 b = test::random_vector(random);
      if (k % 7 == 0) b[0] = 0;
      if (k % 11 == 0) b *= 1e-6;
      if (k % 13 == 0) b.tail<2>().setZero();
      if (b.norm() == 0) continue;
      largest = std::max(largest, miss(GetParam(), w, b, mu, limit, compliance, tangential));
    }
    return largest;
  }
};

TEST_P(EveryLaw, RigidBlocks) { EXPECT_LT(worst(rigid_block), 1e-14); }

TEST_P(EveryLaw, AnyPositiveBlocks) {
  EXPECT_LT(worst([](RandomStream& random) { return gram(random, 3); }), 3e-14);
}

TEST_P(EveryLaw, LargeAndSmallBlocks) {
  EXPECT_LT(worst([](RandomStream& random) { return Mat3(std::pow(10, random.uniform(-8, 8)) * rigid_block(random)); }),
            1e-14);
}

TEST_P(EveryLaw, SlightlyAsymmetricBlocks) {
  EXPECT_LT(worst([](RandomStream& random) {
              const Vec3 skewness = 1e-3 * test::random_vector(random);
              return Mat3(rigid_block(random) + skew(skewness));
            }),
            1e-14);
}

TEST_P(EveryLaw, BlocksThatHardlyMoveAlongOneTangent) {
  EXPECT_LT(worst([](RandomStream& random) {
              const Vec3 scale(1, 1e-5, 1);
              return Mat3(scale.asDiagonal() * gram(random, 3) * scale.asDiagonal());
            }),
            1e-14);
}

TEST_P(EveryLaw, BlocksThatCannotMoveAlongOneTangent) {
  const auto planar = [](RandomStream& random) {
    Mat3 w = gram(random, 3);
    w.row(2).setZero();
    w.col(2).setZero();
    return w;
  };
  EXPECT_LT(worst(planar), 3e-14);
}

TEST_P(EveryLaw, TheStartDoesNotChangeTheAnswer) {
  RandomStream random(5, "start");
  for (int k = 0; k < 300; ++k) {
    const ContactBlock block(rigid_block(random), 0.3, k_none, 0, 0);
    const Vec3 b = test::random_vector(random);
    ContactStart none, far{1e3, 1e3}, near{1e-6, 1e-6};
    const Vec3 r = solve_contact(GetParam(), k_facets, block, b, none);
    EXPECT_LT((solve_contact(GetParam(), k_facets, block, b, far) - r).norm(), 1e-13 * (1 + r.norm()));
    EXPECT_LT((solve_contact(GetParam(), k_facets, block, b, near) - r).norm(), 1e-13 * (1 + r.norm()));
  }
}

TEST_P(EveryLaw, OpensWhereNothingCloses) {
  ContactStart start;
  const ContactBlock block(Mat3::Identity(), 0.5, k_none, 0, 0);
  EXPECT_EQ(solve_contact(GetParam(), k_facets, block, Vec3(2, 1, 0), start).norm(), 0);
  EXPECT_EQ(solve_contact(GetParam(), k_facets, block, Vec3::Zero(), start).norm(), 0);
}

TEST_P(EveryLaw, SidesThatCannotMove) {
  ContactStart start;
  EXPECT_EQ(
      solve_contact(GetParam(), k_facets, ContactBlock(Mat3::Zero(), 0.5, k_none, 0, 0), Vec3(-1, 1, 0), start).norm(),
      0);
  const Vec3 crushed =
      solve_contact(GetParam(), k_facets, ContactBlock(Mat3::Zero(), 0.5, 3, 0, 0), Vec3(-1, 1, 0), start);
  EXPECT_EQ(crushed[0], 3);
}

TEST_P(EveryLaw, ComplianceBetweenSidesThatCannotMove) {
  ContactStart start;
  const Vec3 b(-1, 0.2, 0);
  const Vec3 r = solve_contact(GetParam(), k_facets, ContactBlock(Mat3::Zero(), 0.5, k_none, 0.1, 0), b, start);
  if (GetParam() != Law::ccp) {
    EXPECT_NEAR(r[0], 10, 1e-13);
  }
  EXPECT_LT(law_map(GetParam(), k_facets, {0.5, k_none, 0.1}, r, compliant_velocity(0.1, 0, r, b)), 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw,
                         testing::Values(Law::coulomb, Law::ccp, Law::pyramid, Law::pyramid_k, Law::frictionless));

/// A particle of mass m that meets a wall with (-v, w, 0): W = I/m.
Vec3 velocity_after(Law law, double m, double v, double w, double mu) {
  ContactStart start;
  const Vec3 b(-v, w, 0);
  return solve_contact(law, k_facets, ContactBlock(Mat3::Identity() / m, mu, k_none, 0, 0), b, start) / m + b;
}

TEST(LocalSolve, ParticleSlidesOrSticksInCoulombsLaw) {
  EXPECT_LT((velocity_after(Law::coulomb, 7, 1, 3, 0.5) - Vec3(0, 2.5, 0)).norm(), 1e-15);
  EXPECT_LT(velocity_after(Law::coulomb, 7, 1, 0.4, 0.5).norm(), 1e-14);
}

TEST(LocalSolve, ParticleLiftsInTheConvexLaw) {
  EXPECT_LT((velocity_after(Law::ccp, 7, 1, 3, 0.5) - Vec3(1, 2, 0)).norm(), 1e-15);
  // A particle that only slides, or leaves too slowly, is lifted as well.
  EXPECT_LT((velocity_after(Law::ccp, 7, 0, 3, 0.5) - 3 / 1.25 * Vec3(0.5, 1, 0)).norm(), 1e-15);
  EXPECT_LT((velocity_after(Law::ccp, 7, -1, 3, 0.5) - 3.5 / 1.25 * Vec3(0.5, 1, 0)).norm(), 1e-15);
  EXPECT_EQ(velocity_after(Law::ccp, 7, -2, 3, 0.5), Vec3(2, 3, 0));
}

TEST(LocalSolve, CrushingAtTheLimit) {
  ContactStart start;
  const ContactBlock block(Mat3::Identity() / 2, 0.5, 1, 0, 0);
  const Vec3 slipping = solve_contact(Law::coulomb, k_facets, block, Vec3(-3, 4, 0), start);
  EXPECT_LT((slipping - Vec3(1, -0.5, 0)).norm(), 1e-15);
  const Vec3 sticking = solve_contact(Law::coulomb, k_facets, block, Vec3(-3, 0.1, 0), start);
  EXPECT_LT((sticking - Vec3(1, -0.2, 0)).norm(), 1e-14);
}

TEST(LocalSolve, PolygonFrictionLiesBetweenItsInscribedCircleAndItsCorners) {
  for (const int facets : {3, 4, 7, 64, 1000})
    for (int k = 0; k < 50; ++k) {
      ContactStart start;
      const double phi = 0.13 * k, mu = 0.6;
      const Vec3 b(-1, 9 * std::cos(phi), 9 * std::sin(phi));
      const ContactBlock block(Mat3::Identity(), mu, k_none, 0, 0);
      const Vec3 r = solve_contact(Law::pyramid_k, facets, block, b, start);
      const double ratio = r.tail<2>().norm() / r[0];
      EXPECT_GE(ratio, mu * std::cos(k_pi / facets) - 1e-14);
      EXPECT_LE(ratio, mu + 1e-14);
      EXPECT_LT(law_map(Law::pyramid_k, facets, {mu, k_none, 1}, r, r + b), 1e-12);
    }
}

TEST(LocalSolve, BoxFrictionReachesItsCorner) {
  ContactStart start;
  const ContactBlock block(Mat3::Identity(), 0.5, k_none, 0, 0);
  EXPECT_EQ(solve_contact(Law::pyramid, k_facets, block, Vec3(-2, 5, -3), start), Vec3(2, -1, 1));
}

}  // namespace local_solve_test
}  // namespace nilas::contact
