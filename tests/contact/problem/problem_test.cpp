#include "contact/problem/problem.h"

#include <gtest/gtest.h>

#include <functional>

#include "contact/problem/mass_inverse.h"
#include "core/base/error.h"
#include "tests/support/problems/problem_factory.h"
#include "tests/support/refusal.h"

namespace nilas::contact {
namespace problem_test {

using test::add_body;
using test::random_heap;

/// Blocks of sizes 1, 6 (rigid), 6 (full) and 9, contacts between all and to fixed sides, one within a block.
ContactProblem mixed_problem() {
  RandomStream random(5, "mixed");
  const auto numbers = [&](Eigen::Index rows, Eigen::Index columns) -> MatX {
    return MatX::NullaryExpr(rows, columns, [&](Eigen::Index, Eigen::Index) { return random.normal(); });
  };
  ContactProblem problem;
  problem.h = 0.01;
  const auto full = [&](Eigen::Index n) -> MatX {
    const MatX a = numbers(n, n);
    return a * a.transpose() + MatX::Identity(n, n);
  };
  problem.add_block(full(1));
  problem.add_block(test::mass_matrix({3, Vec3(1, 2, 2.5).asDiagonal(), {}, {}, {}}));
  problem.add_block(full(6));
  problem.add_block(full(9));
  problem.f = numbers(problem.num_velocities(), 1);
  const std::vector<std::pair<int, int>> pairs{{0, 1}, {1, 2}, {2, 3}, {-1, 3}, {1, -1}, {3, 3}, {-1, -1}};
  for (const auto& [a, b] : pairs) {
    const auto rows = [&](int block) -> MatX { return numbers(3, block < 0 ? 0 : problem.block_size(block)); };
    const MatX rows_a = rows(a), rows_b = rows(b);
    problem.add_contact(a, rows_a, b, rows_b, problem.pairs.size());
  }
  problem.w = numbers(problem.w.size(), 1);
  return problem;
}

MatX dense_mass(const ContactProblem& problem) {
  MatX m = MatX::Zero(problem.num_velocities(), problem.num_velocities());
  for (int k = 0; k < problem.num_blocks(); ++k) {
    const int first = problem.block_offset[k];
    m.block(first, first, problem.block_size(k), problem.block_size(k)) = problem.mass(k);
  }
  return m;
}

/// H^T, 3 nc x nv.
MatX dense_rows(const ContactProblem& problem) {
  MatX rows = MatX::Zero(3 * problem.num_contacts(), problem.num_velocities());
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const auto& pair = problem.pairs[c];
    const auto add = [&](int block, const ContactProblem::ConstJacobian& jacobian) {
      if (block < 0) return;
      rows.block(3 * c, problem.block_offset[block], 3, jacobian.cols()) += jacobian;
    };
    add(pair.a, problem.jacobian_a(c));
    add(pair.b, problem.jacobian_b(c));
  }
  return rows;
}

TEST(Problem, StoresWhatWasAdded) {
  ContactProblem problem;
  const Mat6 mass = test::mass_matrix({2, Vec3(1, 2, 3).asDiagonal(), {}, {}, {}});
  EXPECT_EQ(problem.add_block(mass), 0);
  EXPECT_EQ(problem.add_block(MatX::Constant(1, 1, 7)), 1);
  MatX rows_a(3, 6), rows_b(3, 1);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 6; ++j) rows_a(i, j) = 10 * i + j;
  rows_b << 1, 2, 3;
  EXPECT_EQ(problem.add_contact(0, rows_a, 1, rows_b, 42), 0);
  EXPECT_EQ(problem.num_blocks(), 2);
  EXPECT_EQ(problem.num_velocities(), 7);
  EXPECT_EQ(problem.f, VecX::Zero(7));
  EXPECT_EQ(problem.mass(0), MatX(mass));
  EXPECT_EQ(problem.mass(1)(0, 0), 7);
  EXPECT_EQ(MatX(problem.jacobian_a(0)), rows_a);
  EXPECT_EQ(MatX(problem.jacobian_b(0)), rows_b);
  EXPECT_EQ(problem.key[0], 42u);
  EXPECT_TRUE(std::isinf(problem.force_limit[0]));
  EXPECT_EQ(problem.w, VecX::Zero(3));
  EXPECT_THROW(problem.add_contact(0, rows_b, 1, rows_b, 43), ContractError);
  EXPECT_THROW(problem.add_contact(2, rows_a, 1, rows_b, 43), ContractError);
}

TEST(Problem, OperatorsAgreeWithDenseAlgebra) {
  const ContactProblem problem = mixed_problem();
  validate(problem);
  RandomStream random(6, "impulses");
  const VecX r = VecX::NullaryExpr(3 * problem.num_contacts(), [&](Eigen::Index) { return random.normal(); });
  const MatX mass = dense_mass(problem), rows = dense_rows(problem);
  const VecX v = velocities(problem, r);
  EXPECT_LT((mass * v - problem.f - rows.transpose() * r).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((contact_velocities(problem, v) - rows * v - problem.w).cwiseAbs().maxCoeff(), 1e-13);
  const MatX w = rows * mass.ldlt().solve(rows.transpose());
  const auto blocks = delassus_diagonal(problem);
  for (int c = 0; c < problem.num_contacts(); ++c)
    EXPECT_LT((blocks[c] - w.block<3, 3>(3 * c, 3 * c)).cwiseAbs().maxCoeff(), 1e-12) << c;
}

TEST(Problem, RigidBodyBlocksInvertLikeAnyOther) {
  RandomStream random(7, "rigid");
  const Vec3 moments(0.5, 1.2, 1.5);
  const Mat3 axes = Quat(0.3, -0.5, 0.7, 0.2).normalized().matrix();
  ContactProblem problem;
  problem.add_block(test::mass_matrix({2.5, axes * moments.asDiagonal() * axes.transpose(), {}, {}, {}}));
  const Vec6 momentum = Vec6::NullaryExpr([&](Eigen::Index) { return random.normal(); });
  Vec6 velocity;
  MassInverse(problem).apply(0, momentum.data(), velocity.data());
  EXPECT_LT((problem.mass(0) * velocity - momentum).norm(), 1e-14);
}

void expect_refused(const std::string& field, const std::function<void(ContactProblem&)>& spoil) {
  ContactProblem problem = mixed_problem();
  spoil(problem);
  test::expect_refusal<ContractError>([&] { validate(problem); }, {field});
}

TEST(Problem, ValidationNamesTheField) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused("h:", [](auto& p) { p.h = -1; });
  expect_refused("h:", [](auto& p) { p.h = nan; });
  expect_refused("facets", [](auto& p) {
    p.law = Law::pyramid_k;
    p.facets = 2;
  });
  expect_refused("block_offset", [](auto& p) { p.block_offset[1] = 0; });
  expect_refused("mass_offset", [](auto& p) { p.mass_offset.back() += 1; });
  expect_refused("mass_data", [](auto& p) { p.mass_data.pop_back(); });
  expect_refused("mass_data", [](auto& p) { p.mass_data[0] = nan; });
  expect_refused("block 0 is not positive definite", [](auto& p) { p.mass_data[0] = -1; });
  expect_refused("block 1 is not positive definite", [](auto& p) { p.mass_data[p.mass_offset[1] + 35] = 0; });
  expect_refused("block 2 is not symmetric",
                 [](auto& p) { p.mass_data[p.mass_offset[2] + 1] += 0.1 * p.mass_data[p.mass_offset[2]]; });
  expect_refused("f:", [](auto& p) { p.f.conservativeResize(3); });
  expect_refused("f:", [](auto& p) { p.f[4] = nan; });
  expect_refused("pairs", [](auto& p) { p.pairs[0].a = 17; });
  expect_refused("jacobian_offset", [](auto& p) { p.jacobian_offset[1] += 1; });
  expect_refused("jacobian_data", [](auto& p) { p.jacobian_data.push_back(1); });
  expect_refused("jacobian_data", [](auto& p) { p.jacobian_data[2] = nan; });
  expect_refused("w:", [](auto& p) { p.w.conservativeResize(2); });
  expect_refused("w:", [](auto& p) { p.w[2] = nan; });
  expect_refused("mu:", [](auto& p) { p.mu.pop_back(); });
  expect_refused("mu:", [](auto& p) { p.mu[1] = -0.1; });
  expect_refused("mu:", [](auto& p) { p.mu[1] = nan; });
  expect_refused("mu_static", [](auto& p) { p.mu[1] = 0.1; });
  expect_refused("force_limit", [](auto& p) { p.force_limit[0] = -1; });
  expect_refused("force_limit", [](auto& p) { p.force_limit[0] = nan; });
  expect_refused("compliance", [](auto& p) { p.compliance[0] = -1; });
  expect_refused("tangential_compliance", [](auto& p) { p.tangential_compliance[0] = -1; });
  expect_refused("key", [](auto& p) { p.key[1] = p.key[0]; });
  expect_refused("key", [](auto& p) { p.key.pop_back(); });
}

TEST(Problem, RandomHeapsAreValid) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) EXPECT_NO_THROW(validate(random_heap(seed, 6, 12, 0.5)));
  EXPECT_NO_THROW(validate(ContactProblem{}));
}

}  // namespace problem_test
}  // namespace nilas::contact
