#include "contact/problem/islands.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/support/problems/problem_factory.h"

namespace nilas::contact {
namespace islands_test {

ContactProblem graph(int blocks, const std::vector<ContactProblem::Pair>& pairs) {
  ContactProblem problem;
  for (int k = 0; k < blocks; ++k) problem.block_offset.push_back(6 * (k + 1));
  problem.pairs = pairs;
  return problem;
}

TEST(Islands, PrescribedSidesDoNotConnect) {
  const auto islands = find_islands(graph(5, {{-1, 2}, {0, 1}, {3, -1}, {2, 4}, {1, -1}, {-1, -1}, {-1, 4}}));
  const std::vector<std::vector<int>> expected{{0, 3, 6}, {1, 4}, {2}, {5}};
  EXPECT_EQ(islands, expected);
}

TEST(Islands, AChainIsOneIslandWhateverTheOrder) {
  std::vector<ContactProblem::Pair> pairs;
  for (int k = 0; k < 100; ++k) {
    const int link = (37 * k) % 100;
    pairs.push_back(k % 2 == 0 ? ContactProblem::Pair{link, link + 1} : ContactProblem::Pair{link + 1, link});
  }
  const auto islands = find_islands(graph(101, pairs));
  ASSERT_EQ(islands.size(), 1u);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(islands[0][k], k);
}

/// A problem in which every entry differs from its default and from all others.
ContactProblem telling_problem() {
  ContactProblem problem = test::box_stack({1, 2, 3}, 0.5);  // contacts touch all blocks
  problem.law = Law::pyramid;
  problem.facets = 11;
  problem.h = 0.125;
  const MatX none(3, 0), turning = 0.25 * MatX::Identity(3, 6);
  problem.add_moment(0, problem.pairs[0].a < 0 ? none : turning, problem.pairs[0].b < 0 ? none : turning, 0.5, 999);
  double next = 1;
  for_each_list(problem, problem, [&](auto& list, const auto&) {
    for (auto& value : list) value = static_cast<std::decay_t<decltype(value)>>(next++);
  });
  for (double& w : problem.w) w = next++;
  return problem;
}

std::vector<int> all_of(int count) {
  std::vector<int> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Selecting all contacts loses nothing, whatever members a problem has.
TEST(Select, AllContactsAreTheProblemItself) {
  const ContactProblem problem = telling_problem();
  EXPECT_TRUE(select(problem, all_of(problem.num_contacts())) == problem);
  const LocalProblem local = reduce(test::random_heap(5, 6, 8, 0.3));
  EXPECT_TRUE(select(local, all_of(local.num_contacts())) == local);
}

/// Every list per contact is visited: the struct has no other members than the lists, the law and its facets.
TEST(Coefficients, EveryListIsVisited) {
  ContactCoefficients coefficients;
  std::size_t bytes = sizeof(coefficients.law) + sizeof(coefficients.facets);
  for_each_list(coefficients, coefficients, [&](auto& list, const auto& same) {
    EXPECT_EQ(&list, &same);
    bytes += sizeof(list);
  });
  EXPECT_EQ(bytes, sizeof(ContactCoefficients));
}

TEST(Coefficients, StandInTheOrderAskedFor) {
  const ContactProblem problem = telling_problem();
  const ContactCoefficients part = select(static_cast<const ContactCoefficients&>(problem), {4, 1});
  EXPECT_EQ(part.law, problem.law);
  EXPECT_EQ(part.facets, problem.facets);
  EXPECT_EQ(part.mu, (std::vector<double>{problem.mu[4], problem.mu[1]}));
  EXPECT_EQ(part.key, (std::vector<std::uint64_t>{problem.key[4], problem.key[1]}));
}

TEST(Coefficients, AreThoseOfTheReducedProblem) {
  const ContactProblem problem = test::random_heap(5, 6, 8, 0.3);
  EXPECT_TRUE(static_cast<const ContactCoefficients&>(reduce(problem)) == problem);
}

TEST(Islands, NoContactsNoIslands) { EXPECT_TRUE(find_islands(graph(3, {})).empty()); }

}  // namespace islands_test
}  // namespace nilas::contact
