/// Islands whose Delassus operator is too large are solved without it, or left alone with a message.
#include "contact/reducible.h"

#include <gtest/gtest.h>

#include <numeric>

#include "contact/registry.h"
#include "tests/support/problem_factory.h"

namespace nilas {
namespace {

/// `count` particles falling on one body that they outweigh tenfold: all contacts share it.
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

TEST(Reducible, AutoSolvesWhatIsNotAndNewtonSaysSo) {
  const ContactProblem problem = rain(3000);
  const auto solve = [&](const char* name) {
    return find_solver(name).make({.tolerance = 1e-8, .max_iterations = 2000})->solve(problem, {});
  };
  const ContactSolution solution = solve("auto");
  EXPECT_EQ(solution.status, SolveStatus::converged) << solution.message;
  EXPECT_LE(measure(problem, solution.r).natural_map_m_s, 1e-8);
  EXPECT_NE(solution.message.find("more nsgs"), std::string::npos) << solution.message;
  const ContactSolution refused = solve("newton");
  EXPECT_EQ(refused.status, SolveStatus::numerical_error);
  EXPECT_NE(refused.message.find("3000 contacts"), std::string::npos) << refused.message;
}

}  // namespace
}  // namespace nilas
