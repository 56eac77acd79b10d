#include <gtest/gtest.h>

#include <algorithm>

#include "contact/solvers/bodies/node_cholesky.h"
#include "contact/solvers/bodies/node_lu.h"
#include "tests/contact/solvers/bodies/island_with_vessel.h"

namespace nilas::solvers {
namespace node_factors_test {

/// An island with random matrices G and the dense matrix 1 + sum J^T G J.
struct Case {
  contact::ContactProblem problem;
  contact::PreparedProblem prepared;
  BodyIsland bodies;
  NodePlan plan;
  std::vector<Mat3> g;
  MatX dense;

  Case(std::uint64_t seed, int num_bodies, int contacts, bool symmetric)
      : problem(test::largest_island(test::heap_with_vessel(seed, num_bodies, contacts, 0.3))),
        prepared(problem),
        bodies(prepared),
        plan(plan_nodes(bodies).value()) {
    RandomStream random(seed, "g");
    const Eigen::Index size = Eigen::Index{k_node_size} * bodies.num_nodes();
    dense = MatX::Identity(size, size);
    for (int c = 0; c < bodies.num_contacts(); ++c) {
      Mat3 root;
      for (int k = 0; k < 9; ++k) root.data()[k] = random.normal();
      g.emplace_back(root * root.transpose());
      if (!symmetric) g.back()(0, 1) += 0.5;
      MatX j = MatX::Zero(3, size);
      for (int side = bodies.first_side(c); side < bodies.first_side(c + 1); ++side)
        for (int i = 0; i < 3; ++i)
          for (int k = 0; k < k_node_size; ++k) j(i, k_node_size * bodies.node(side) + k) = bodies.rows(side).row[i][k];
      dense += j.transpose() * g.back() * j;
    }
  }

  VecX right() const { return VecX::LinSpaced(dense.rows(), -1, 2); }
  NodeVector nodes(const VecX& x) const {
    NodeVector out(static_cast<std::size_t>(bodies.num_nodes()));
    for (Eigen::Index i = 0; i < x.size(); ++i) out[i / k_node_size].value[i % k_node_size] = x[i];
    return out;
  }
  VecX flat(const NodeVector& x) const {
    VecX out(dense.rows());
    for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = x[i / k_node_size].value[i % k_node_size];
    return out;
  }
};

TEST(NodeCholesky, SolvesWhatADenseFactorisationSolves) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Case one(seed, 4 + 3 * static_cast<int>(seed), 8 + 6 * static_cast<int>(seed), true);
    ContactMatrices g(one.g.size());
    for (std::size_t c = 0; c < one.g.size(); ++c) {
      const Mat3& m = one.g[c];
      const double entries[] = {m(0, 0), m(1, 0), m(2, 0), m(1, 1), m(2, 1), m(2, 2)};
      for (std::size_t i = 0; i < 6; ++i) g.entry[i][c] = entries[i];
    }
    NodeCholesky factors(one.bodies, one.plan);
    ASSERT_TRUE(factors.factor(g));
    NodeVector x = one.nodes(one.right());
    factors.solve(x);
    EXPECT_LT((one.dense * one.flat(x) - one.right()).norm(), 1e-10 * one.right().norm()) << seed;
  }
}

TEST(NodeLu, SolvesWhatADenseFactorisationSolves) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Case one(seed, 4 + 3 * static_cast<int>(seed), 8 + 6 * static_cast<int>(seed), false);
    NodeLu factors(one.bodies, one.plan);
    ASSERT_TRUE(factors.factor(one.g));
    NodeVector x = one.nodes(one.right());
    factors.solve(x);
    EXPECT_LT((one.dense * one.flat(x) - one.right()).norm(), 1e-9 * one.right().norm()) << seed;
  }
}

TEST(NodeFactors, RefuseWhatIsNotFinite) {
  Case one(1, 6, 12, true);
  ContactMatrices g(one.g.size());
  for (auto& entries : g.entry) std::fill(entries.begin(), entries.end(), std::nan(""));
  EXPECT_FALSE(NodeCholesky(one.bodies, one.plan).factor(g));
  one.g.front().setConstant(std::nan(""));
  EXPECT_FALSE(NodeLu(one.bodies, one.plan).factor(one.g));
}

/// J and z_free give the velocities of the problem itself, those of a vessel of nine speeds among them.
TEST(BodyIsland, HasTheVelocitiesOfTheProblem) {
  const Case one(3, 7, 14, true);
  RandomStream random(7, "impulses");
  VecX r(3 * one.problem.num_contacts());
  for (double& x : r) x = random.normal();
  NodeVector z = one.bodies.free_motion();
  one.bodies.add_impulses(by_component(r), z);
  ContactVectors u(static_cast<std::size_t>(one.problem.num_contacts()));
  one.bodies.relative_velocities(z, u);
  const VecX expected = contact::contact_velocities(one.problem, contact::velocities(one.prepared, r));
  EXPECT_LT((by_contact(u) + one.problem.w - expected).norm(), 1e-12 * expected.norm());
  EXPECT_EQ(one.bodies.num_nodes(), one.problem.num_blocks() + 1);
}

}  // namespace node_factors_test
}  // namespace nilas::solvers
