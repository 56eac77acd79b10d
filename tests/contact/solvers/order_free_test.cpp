/// Tests of eg-order-free and newton-order-free: the same bits for any order of contacts and bodies, for any thread
/// count, and for mirror images.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "contact/problem/row_of.h"
#include "contact/registry.h"
#include "contact/solvers/shared/colouring.h"
#include "tests/support/problems/problem_changes.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::solvers {
namespace order_free_test {

constexpr int k_iterations = 400;

contact::ContactSolution solve(const contact::ContactProblem& problem, const std::string& name,
                               int iterations = k_iterations, int threads = 1) {
  return contact::find_solver(name)
      .make({.tolerance = 1e-6, .max_iterations = iterations, .threads = threads})
      ->solve(problem, {});
}

std::vector<int> shuffled(int count, std::uint64_t seed) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  RandomStream random(seed, "shuffle");
  for (int k = count - 1; k > 0; --k) std::swap(order[k], order[random.bits() % static_cast<std::uint64_t>(k + 1)]);
  return order;
}

/// The problem with permuted blocks: block k is block order[k] of `problem`.
contact::ContactProblem with_block_order(const contact::ContactProblem& problem, const std::vector<int>& order) {
  contact::ContactProblem out;
  out.h = problem.h;
  out.law = problem.law;
  out.facets = problem.facets;
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const int old = order[k];
    place[old] = static_cast<int>(k);
    out.add_block(problem.mass(old));
    out.f.tail(problem.block_size(old)) = problem.f.segment(problem.block_offset[old], problem.block_size(old));
  }
  contact::ContactProblem moved = problem;
  for (auto& pair : moved.pairs)
    for (int* k : {&pair.a, &pair.b})
      if (*k >= 0) *k = place[*k];
  for (int c = 0; c < problem.num_contacts(); ++c) test::copy_contact(moved, c, problem.key[c], c % 3 == 0, out);
  return out;
}

/// Signs of (vx, vy, vz, wx, wy, wz) in the mirror image in the plane y = 0.
constexpr double k_signs[6] = {1, -1, 1, -1, 1, -1};

/// The mirror image, with second tangents reversed.
contact::ContactProblem mirrored(const contact::ContactProblem& problem) {
  contact::ContactProblem out = problem;
  for (int k = 0; k < problem.num_blocks(); ++k)
    for (int i = 0; i < 6; ++i) {
      out.f[6 * k + i] *= k_signs[i];
      for (int j = 0; j < 6; ++j)
        out.mass_data[out.mass_offset[k] + static_cast<std::size_t>(6 * j + i)] *= k_signs[i] * k_signs[j];
    }
  for (int c = 0; c < problem.num_contacts(); ++c) {
    for (const auto& rows : {out.jacobian_a(c), out.jacobian_b(c)}) {
      double* const data = out.jacobian_data.data() + (rows.data() - out.jacobian_data.data());
      for (Eigen::Index i = 0; i < 3; ++i)
        for (Eigen::Index j = 0; j < rows.cols(); ++j) data[i * rows.cols() + j] *= (i == 2 ? -1 : 1) * k_signs[j];
    }
    out.w[3 * c + 2] *= -1;
  }
  return out;
}

/// Problems with enough contacts and bodies for visible rounding of sums.
std::vector<contact::ContactProblem> subjects() {
  std::vector<contact::ContactProblem> all{test::random_heap(7, 40, 200, 0.4), test::raft(12, 0.3, 0.6, 5)};
  all.push_back(all.front());
  all.back().law = Law::ccp;
  all.push_back(all.front());
  all.back().law = Law::pyramid_k;
  return all;
}

class OrderFree : public testing::TestWithParam<const char*> {
 protected:
  contact::ContactSolution solve(const contact::ContactProblem& problem) const {
    return order_free_test::solve(problem, GetParam());
  }
};
INSTANTIATE_TEST_SUITE_P(Solvers, OrderFree, testing::Values("eg-order-free", "newton-order-free"),
                         [](const auto& one) {
                           std::string name = one.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST_P(OrderFree, PermutedContactsGiveTheSameBits) {
  for (const contact::ContactProblem& problem : subjects()) {
    const contact::ContactSolution one = solve(problem);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const auto order = shuffled(problem.num_contacts(), seed);
      const contact::ContactSolution two = solve(test::with_order(problem, order));
      EXPECT_EQ(one.v, two.v);
      EXPECT_EQ(one.iterations, two.iterations);
      for (std::size_t k = 0; k < order.size(); ++k)
        EXPECT_EQ(Vec3(one.r.segment<3>(3 * order[k])), Vec3(two.r.segment<3>(contact::row_of(k))));
    }
  }
}

TEST_P(OrderFree, PermutedBodiesAndSwappedSidesGiveTheSameBits) {
  for (const contact::ContactProblem& problem : subjects()) {
    const contact::ContactSolution one = solve(problem);
    const auto order = shuffled(problem.num_blocks(), 9);
    const contact::ContactSolution two = solve(with_block_order(problem, order));
    EXPECT_EQ(one.r, two.r);
    for (std::size_t k = 0; k < order.size(); ++k)
      EXPECT_EQ(Vec6(one.v.segment<6>(6 * order[k])), Vec6(two.v.segment<6>(6 * static_cast<Eigen::Index>(k))));
  }
}

TEST_P(OrderFree, MirrorImagesGiveTheMirroredBits) {
  for (const contact::ContactProblem& problem : subjects()) {
    if (problem.law == Law::pyramid_k) continue;  // The corners of the polygon are not mirrored.
    const contact::ContactSolution one = solve(problem), two = solve(mirrored(problem));
    EXPECT_EQ(one.iterations, two.iterations);
    for (int k = 0; k < problem.num_blocks(); ++k)
      for (int i = 0; i < 6; ++i) EXPECT_EQ(two.v[6 * k + i], k_signs[i] * one.v[6 * k + i]);
  }
}

/// newton-order-free converges, and each solver reports convergence exactly when its residual meets the tolerance.
TEST_P(OrderFree, ReachesTheTolerance) {
  const contact::ContactProblem problem = test::random_heap(7, 40, 200, 0.4);
  const contact::ContactSolution found = solve(problem);
  if (std::string(GetParam()) == "newton-order-free") {
    EXPECT_EQ(found.status, contact::SolveStatus::converged);
  }
  EXPECT_EQ(found.status == contact::SolveStatus::converged, contact::measure(problem, found.r).law_map_m_s <= 1e-6);
}

/// A particle (three velocities) touches a body (six): the body's rows begin at an odd index.
TEST(OrderFreeSolvers, BlocksOfUnlikeSize) {
  contact::ContactProblem problem;
  problem.h = 0.01;
  problem.add_block(2 * Mat3::Identity());
  problem.f << -2, 0.5, 0.2;
  const test::TestBody body;
  test::add_body(problem, body);
  MatX particle = MatX::Identity(3, 3);
  problem.add_contact(0, particle, 1, test::body_rows(Mat3::Identity(), Vec3(0.1, 0.2, 0.3), body.p, -1), 1);
  problem.mu[0] = problem.mu_static[0] = 0.3;
  const contact::ContactSolution expected = solve(problem, "enumerate");
  for (const char* name : {"eg", "eg-order-free", "newton-order-free", "apgd", "nsgs"})
    EXPECT_LT((solve(problem, name).v - expected.v).norm(), 1e-5) << name;
  EXPECT_GT(expected.r[0], 0);
}

TEST(OrderFreeSolvers, ThePlainSolverDoesNotHaveThisProperty) {
  const contact::ContactProblem problem = test::random_heap(7, 40, 200, 0.4);
  const auto order = shuffled(problem.num_contacts(), 1);
  EXPECT_NE(solve(problem, "eg").v, solve(test::with_order(problem, order), "eg").v);
}

/// The islands are large enough to be coloured and distributed.
TEST(Threads, LargeIslandsGiveTheSameBitsOnAnyNumber) {
  const contact::ContactProblem problem = test::raft(24, 0.3, 1.0, 5);
  ASSERT_GE(problem.num_contacts(), static_cast<int>(k_fewest_coloured));
  for (const char* name : {"nsgs", "eg", "eg-order-free", "apgd", "pgs"}) {
    contact::ContactProblem asked = problem;
    if (std::string(name) == "pgs") asked.law = Law::pyramid;
    constexpr int k_few = 20;  // More threads than cores wait for each other.
    const contact::ContactSolution one = solve(asked, name, k_few, 1);
    for (const int threads : {2, 3})
      EXPECT_EQ(one.r, solve(asked, name, k_few, threads).r) << name << " on " << threads;
  }
}

TEST(Colouring, RunsOfOneColourShareNoBlock) {
  contact::ContactProblem problem = test::raft(24, 0.3, 1.0, 5);
  std::vector<int> contacts(static_cast<std::size_t>(problem.num_contacts())), runs, colours;
  std::iota(contacts.begin(), contacts.end(), 0);
  // One body touches many: its contacts are solved one after the other.
  for (int c = 0; c < 200; c += 2) problem.pairs[c].b = 0;
  colour(problem, contacts, 10, runs, colours);
  std::vector<int> sorted = contacts;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t c = 0; c < sorted.size(); ++c) EXPECT_EQ(sorted[c], static_cast<int>(c));
  ASSERT_GE(colours.size(), 3u);
  EXPECT_LT(runs.back() - 10, problem.num_contacts()) << "the crowded body's contacts are left out";
  const auto pair_at = [&](int place) { return problem.pairs[contacts[place - 10]]; };
  for (std::size_t k = 0; k + 1 < colours.size(); ++k) {
    std::vector<int> seen;
    for (int run = colours[k]; run < colours[k + 1]; ++run) {
      const auto first = pair_at(runs[run]);
      for (int place = runs[run]; place < runs[static_cast<std::size_t>(run) + 1]; ++place) {
        EXPECT_EQ(pair_at(place).a, first.a);
        EXPECT_EQ(pair_at(place).b, first.b);
      }
      for (const int block : {first.a, first.b}) {
        if (block < 0) continue;
        EXPECT_EQ(std::count(seen.begin(), seen.end(), block), 0);
        seen.push_back(block);
      }
    }
  }
}

}  // namespace order_free_test
}  // namespace nilas::solvers
