/// Islands whose Delassus operator is too large are solved without it, or left unsolved with a message.
#include "contact/problem/reducible.h"

#include <gtest/gtest.h>

#include <numeric>

#include "contact/registry.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::contact {
namespace reducible_test {

/// `count` particles of 1 kg that fall on one body of 300 kg. All contacts share the body.
ContactProblem rain(int count) {
  ContactProblem problem;
  problem.h = 0.01;
  problem.add_block(300 * Mat3::Identity());
  MatX rows = Mat3::Identity();
  for (int k = 0; k < count; ++k) {
    const int block = problem.add_block(Mat3::Identity());
    problem.f.tail<3>() = Vec3(-1, 0.1, 0);
    problem.add_contact(0, -rows, block, rows, static_cast<std::uint64_t>(k) + 1);
    problem.mu.back() = problem.mu_static.back() = 0.5;
  }
  return problem;
}

TEST(Reducible, CountsTheBlocksOfW) {
  std::vector<int> contacts(3000);
  std::iota(contacts.begin(), contacts.end(), 0);
  const ContactProblem problem = rain(3000);
  EXPECT_FALSE(is_reducible(problem, contacts));
  contacts.resize(2000);
  EXPECT_TRUE(is_reducible(problem, contacts));
}

/// Particles on a grid of the given sides, each touching the next along every side.
ContactProblem lattice(int a, int b, int c) {
  ContactProblem problem;
  problem.h = 0.01;
  const MatX rows = Mat3::Identity();
  for (int k = 0; k < a * b * c; ++k) problem.add_block(Mat3::Identity());
  const auto block = [&](int i, int j, int k) { return (i * b + j) * c + k; };
  const auto touch = [&](int one, int other) {
    problem.add_contact(one, -rows, other, rows, static_cast<std::uint64_t>(problem.num_contacts()) + 1);
  };
  for (int i = 0; i < a; ++i)
    for (int j = 0; j < b; ++j)
      for (int k = 0; k < c; ++k) {
        if (i + 1 < a) touch(block(i, j, k), block(i + 1, j, k));
        if (j + 1 < b) touch(block(i, j, k), block(i, j + 1, k));
        if (k + 1 < c) touch(block(i, j, k), block(i, j, k + 1));
      }
  return problem;
}

TEST(Reducible, CountsTheFillOfLargeIslands) {
  const auto whole = [](const ContactProblem& problem) {
    std::vector<int> contacts(static_cast<std::size_t>(problem.num_contacts()));
    std::iota(contacts.begin(), contacts.end(), 0);
    return contacts;
  };
  const ContactProblem sheet = lattice(1, 120, 120), heap = lattice(32, 32, 32);
  EXPECT_GT(sheet.num_contacts(), 25000);
  EXPECT_TRUE(is_reducible(sheet, whole(sheet)));
  EXPECT_GT(heap.num_contacts(), 90000);
  EXPECT_FALSE(is_reducible(heap, whole(heap)));
}

TEST(Reducible, AutoSolvesWhatIsNotAndNewtonSaysSo) {
  const ContactProblem problem = rain(3000);
  const auto solve = [&](const char* name) {
    return find_solver(name).make({.tolerance = 1e-8, .max_iterations = 2000})->solve(problem, {});
  };
  const ContactSolution solution = solve("auto");
  EXPECT_EQ(solution.status, SolveStatus::converged) << solution.message;
  EXPECT_LE(measure(problem, solution.r).natural_map_m_s, 1e-8);
  EXPECT_NE(solution.message.find("interior point"), std::string::npos) << solution.message;
  ContactProblem on_pyramids = problem;  // a law that is not solved on the bodies
  on_pyramids.law = Law::pyramid;
  const ContactSolution swept =
      find_solver("auto").make({.tolerance = 1e-8, .max_iterations = 2000})->solve(on_pyramids, {});
  EXPECT_NE(swept.message.find("more nsgs"), std::string::npos) << swept.message;
  const ContactSolution refused = solve("newton");
  EXPECT_EQ(refused.status, SolveStatus::numerical_error);
  EXPECT_NE(refused.message.find("3000 contacts"), std::string::npos) << refused.message;
}

}  // namespace reducible_test
}  // namespace nilas::contact
