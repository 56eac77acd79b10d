#include "contact/problem/islands.h"

#include <gtest/gtest.h>

namespace nilas {
namespace {

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
  for (int k = 0; k < 100; ++k) EXPECT_EQ(islands[0][static_cast<std::size_t>(k)], k);
}

TEST(Islands, NoContactsNoIslands) { EXPECT_TRUE(find_islands(graph(3, {})).empty()); }

}  // namespace
}  // namespace nilas
