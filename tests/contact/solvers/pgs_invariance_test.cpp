/// Changes of a problem that must not change the solution of pgs, in addition to those of invariance_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>

#include "contact/problem/islands.h"
#include "contact/solvers/pgs.h"
#include "tests/support/problems/problem_changes.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::solvers {
namespace pgs_invariance_test {

contact::ContactSolution solve(const contact::ContactProblem& problem, int threads = 1) {
  return PgsSolver({.shared = {.tolerance = 1e-12, .max_iterations = 500000, .threads = threads}}).solve(problem, {});
}

/// The same heap in a frame turned by R. Contact rows are made anew, with tangents turned by an angle of each contact's
/// own.
contact::ContactProblem turned(const contact::ContactProblem& problem, const Mat3& R) {
  contact::ContactProblem out = problem;
  Mat6 blocks = Mat6::Zero();
  blocks.topLeftCorner<3, 3>() = R;
  blocks.bottomRightCorner<3, 3>() = R;
  for (int k = 0; k < problem.num_blocks(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Mat6 mass = blocks * problem.mass(k) * blocks.transpose();
    Eigen::Map<Mat6>(out.mass_data.data() + out.mass_offset[i]) = mass;
    out.f.segment<6>(out.block_offset[i]) = blocks * problem.f.segment<6>(problem.block_offset[i]);
  }
  for (std::size_t k = 0; k < out.jacobian_data.size(); k += 3) {
    Eigen::Map<Vec3> part(out.jacobian_data.data() + k);
    part = R * Vec3(part);
  }
  return out;
}

TEST(PgsInvariance, RotationOfTheWholeScene) {
  const Mat3 R = Quat(0.3, -0.4, 0.8, 0.1).normalized().matrix();
  for (const Law law : {Law::coulomb, Law::pyramid}) {
    contact::ContactProblem problem = test::random_heap(2, 8, 12, 0.3);
    problem.law = law;
    const VecX v = solve(problem).v, v_turned = solve(turned(problem, R)).v;
    for (int k = 0; k < v.size(); k += 3) EXPECT_LT((R * v.segment<3>(k) - v_turned.segment<3>(k)).norm(), 1e-9);
  }
}

TEST(PgsInvariance, TangentsMatterToThePyramidAloneAndQuarterTurnsToNeither) {
  contact::ContactProblem problem = test::random_heap(2, 8, 12, 0.3);
  const auto change = [&](Law law, double angle) {
    problem.law = law;
    return (solve(problem).v - solve(test::with_turned_tangents(problem, angle)).v).cwiseAbs().maxCoeff();
  };
  EXPECT_LT(change(Law::coulomb, 0.6), 1e-9);
  EXPECT_LT(change(Law::pyramid, k_pi / 2), 1e-9);
  EXPECT_GT(change(Law::pyramid, 0.6), 1e-3);
}

TEST(PgsInvariance, IslandsApartAndTogether) {
  contact::ContactProblem problem = test::random_heap(2, 14, 9, 0.3);
  problem.law = Law::coulomb;
  ASSERT_GT(contact::find_islands(problem).size(), 1u);
  contact::ContactProblem linked = problem;  // Open contacts join all bodies into one island.
  for (int k = 0; k + 1 < problem.num_blocks(); ++k) {
    linked.add_contact(k, MatX::Ones(3, 6), k + 1, -MatX::Ones(3, 6), 1000 + static_cast<std::uint64_t>(k));
    linked.w[linked.w.size() - 3] = 1e6;
  }
  ASSERT_EQ(contact::find_islands(linked).size(), 1u);
  EXPECT_LT((solve(problem).v - solve(linked).v).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(PgsInvariance, AFarCopyGivesTheSameBits) {
  const contact::ContactProblem one = test::random_heap(3, 6, 11, 0.3);
  contact::ContactProblem two = one;
  for (int k = 0; k < one.num_blocks(); ++k) two.add_block(one.mass(k));
  two.f.tail(one.f.size()) = one.f;
  const auto shifted = [&](int k) { return k < 0 ? -1 : k + one.num_blocks(); };
  for (int c = 0; c < one.num_contacts(); ++c) {
    const auto& pair = one.pairs[c];
    two.add_contact(shifted(pair.a), one.jacobian_a(c), shifted(pair.b), one.jacobian_b(c),
                    500 + static_cast<std::uint64_t>(c));
    two.mu.back() = two.mu_static.back() = one.mu[c];
  }
  const contact::ContactSolution a = solve(one), b = solve(two);
  EXPECT_EQ(a.r, b.r.head(a.r.size()));
  EXPECT_EQ(a.r, b.r.tail(a.r.size()));
  EXPECT_EQ(a.v, b.v.tail(a.v.size()));
}

TEST(PgsInvariance, SameBitsForOneAndTwoThreads) {
  contact::ContactProblem problem = test::random_heap(11, 400, 150, 0.3);
  ASSERT_GT(contact::find_islands(problem).size(), 50u);
  for (const Law law : {Law::pyramid, Law::coulomb, Law::frictionless}) {
    problem.law = law;
    const contact::ContactSolution one = solve(problem, 1), two = solve(problem, 2);
    EXPECT_EQ(one.r, two.r);
    EXPECT_EQ(one.v, two.v);
    EXPECT_EQ(one.iterations, two.iterations);
    EXPECT_EQ(one.r, solve(problem, 1).r);
  }
}

/// The same problem with blocks 0 and 1 as one block of twelve: contacts have blocks of any size, and both sides in
/// one.
contact::ContactProblem merged(const contact::ContactProblem& problem) {
  contact::ContactProblem out;
  out.h = problem.h;
  out.law = problem.law;
  MatX mass = MatX::Zero(12, 12);
  mass.topLeftCorner<6, 6>() = problem.mass(0);
  mass.bottomRightCorner<6, 6>() = problem.mass(1);
  out.add_block(mass);
  for (int k = 2; k < problem.num_blocks(); ++k) out.add_block(problem.mass(k));
  out.f = problem.f;
  const auto block = [](int k) { return k <= 0 ? k : k - 1; };
  const auto rows = [&](int k, const contact::ContactProblem::ConstJacobian& jacobian) -> MatX {
    if (k < 0 || k > 1) return jacobian;
    MatX wide = MatX::Zero(3, 12);
    wide.middleCols(6 * k, 6) = jacobian;
    return wide;
  };
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const auto i = static_cast<std::size_t>(c);
    const auto& pair = problem.pairs[i];
    const MatX rows_a = rows(pair.a, problem.jacobian_a(c)), rows_b = rows(pair.b, problem.jacobian_b(c));
    out.add_contact(block(pair.a), rows_a, block(pair.b), rows_b, problem.key[i]);
    out.mu.back() = out.mu_static.back() = problem.mu[i];
  }
  return out;
}

TEST(PgsInvariance, BlocksOfAnySizeAreSweptAlike) {
  for (const Law law : {Law::pyramid, Law::coulomb, Law::frictionless}) {
    contact::ContactProblem problem = test::random_heap(6, 5, 14, 0.3);
    problem.law = law;
    const contact::ContactProblem general = merged(problem);
    ASSERT_TRUE(std::any_of(general.pairs.begin(), general.pairs.end(), [](const auto& p) { return p.a == p.b; }));
    for (const int sweeps : {1, 10}) {
      const PgsSolver solver({.shared = {.tolerance = 0, .max_iterations = sweeps}});
      EXPECT_LT((solver.solve(problem, {}).r - solver.solve(general, {}).r).cwiseAbs().maxCoeff(), 1e-12);
    }
  }
}

TEST(PgsInvariance, SweepsAreSequentialOnSingleRows) {
  // The definition, row by row on dense matrices, is compared with the blockwise arithmetic of the sweeps.
  for (const Law law : {Law::pyramid, Law::coulomb}) {
    contact::ContactProblem problem = test::random_heap(8, 4, 9, 0.4);
    problem.law = law;
    const int rows = 3 * problem.num_contacts();
    MatX jacobian = MatX::Zero(rows, problem.num_velocities());
    MatX mass = MatX::Zero(problem.num_velocities(), problem.num_velocities());
    for (int k = 0; k < problem.num_blocks(); ++k) mass.block<6, 6>(6 * k, 6 * k) = problem.mass(k);
    for (int c = 0; c < problem.num_contacts(); ++c) {
      const auto& pair = problem.pairs[c];
      if (pair.a >= 0) jacobian.block<3, 6>(3 * c, 6 * pair.a) = problem.jacobian_a(c);
      if (pair.b >= 0) jacobian.block<3, 6>(3 * c, 6 * pair.b) = problem.jacobian_b(c);
    }
    const MatX w = jacobian * mass.ldlt().solve(jacobian.transpose());
    const VecX q = jacobian * mass.ldlt().solve(problem.f) + problem.w;
    VecX r = VecX::Zero(rows);
    const auto step = [&](int i, double inverse_mass) { return r[i] - (w.row(i).dot(r) + q[i]) / inverse_mass; };
    for (int sweep = 0; sweep < 5; ++sweep)
      for (int c = 0; c < problem.num_contacts(); ++c) {
        const int n = 3 * c;
        r[n] = std::max(0.0, step(n, w(n, n)));
        const double bound = problem.mu[c] * r[n];
        if (law == Law::pyramid) {
          for (int i = n + 1; i < n + 3; ++i) r[i] = std::clamp(step(i, w(i, i)), -bound, bound);
        } else {
          const double larger = std::max(w(n + 1, n + 1), w(n + 2, n + 2));
          const Vec2 t(step(n + 1, larger), step(n + 2, larger));
          r.segment<2>(n + 1) = t.norm() > bound ? Vec2(bound / t.norm() * t) : t;
        }
      }
    const PgsSolver solver({.shared = {.tolerance = 0, .max_iterations = 5}});
    EXPECT_LT((solver.solve(problem, {}).r - r).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(PgsInvariance, ContactImpulsesCarryNoMomentumOfTheirOwn) {
  RandomStream random(1, "momentum");
  std::vector<test::TestBody> bodies{{2, Vec3(1, 2, 3).asDiagonal(), Vec3(0.3, -2, 1), Vec3(1, 0, 2), Vec3(0, 1, 0)},
                                     {5, Vec3(3, 2, 4).asDiagonal(), Vec3(2, 1, -1), Vec3(-1, 1, 0), Vec3(1, 0, 0)}};
  contact::ContactProblem problem;
  problem.law = Law::coulomb;
  for (const auto& body : bodies) test::add_body(problem, body);
  for (int k = 0; k < 5; ++k)
    test::add_contact(problem, bodies, 0, 1, test::random_vector(random),
                      test::frame_of(test::random_vector(random).normalized()), 0.5);
  const contact::ContactSolution s = solve(problem);
  ASSERT_GT(s.r.norm(), 0.1);
  VecX gained = -problem.f;
  for (int k = 0; k < 2; ++k) gained.segment<6>(6 * k) += problem.mass(k) * s.v.segment<6>(6 * k);
  const Vec3 linear = gained.segment<3>(0) + gained.segment<3>(6);
  const Vec3 angular = gained.segment<3>(3) + bodies[0].p.cross(gained.segment<3>(0)) + gained.segment<3>(9) +
                       bodies[1].p.cross(gained.segment<3>(6));
  EXPECT_LT(linear.norm(), 1e-14 * std::max(1.0, s.r.norm()));
  EXPECT_LT(angular.norm(), 2e-14 * std::max(1.0, s.r.norm()));
}

}  // namespace pgs_invariance_test
}  // namespace nilas::solvers
