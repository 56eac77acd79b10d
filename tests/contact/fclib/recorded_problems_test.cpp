/// The problems of tests/data/fclib are small, and their stored impulses solve them.
#include "tests/contact/fclib/recorded_problems.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/measure/measure.h"

namespace nilas::contact {
namespace recorded_problems_test {

TEST(OwnProblems, AreFiveSmallFiles) {
  const auto files = test::own_problems();
  EXPECT_EQ(files.size(), 5u);
  for (const auto& file : files) EXPECT_LT(std::filesystem::file_size(file), 100000u) << file;
}

TEST(OwnProblems, HoldTheirSolutions) {
  for (const auto& path : test::own_problems()) {
    const FclibProblem file = read_fclib(path);
    ASSERT_TRUE(file.solution.has_value()) << path;
    const auto& problem = std::get<ContactProblem>(file.problem);
    EXPECT_EQ(problem.law, Law::coulomb) << path;
    EXPECT_LE(measure(problem, *file.solution).law_map_m_s, 1e-10) << path;
  }
}

/// One of the problems needs data that FCLIB cannot store.
TEST(OwnProblems, LevelIceHasContactsWithALimitOfForce) {
  const FclibProblem file = read_fclib(test::own_problem("scene-level-ice"));
  const auto& limits = std::get<ContactProblem>(file.problem).force_limit;
  EXPECT_TRUE(std::any_of(limits.begin(), limits.end(), [](double limit) { return std::isfinite(limit); }));
}

}  // namespace recorded_problems_test
}  // namespace nilas::contact
