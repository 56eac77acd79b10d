#include "contact/problem/block_fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/base/random.h"

namespace nilas::contact {
namespace block_fill_test {

using Pattern = std::vector<std::set<int>>;

/// The pattern of n rows, each joined to a few near rows. Every other entry is listed on one side only.
Pattern band(int n, int reach, std::uint64_t seed) {
  RandomStream random(seed, "band");
  Pattern rows(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    rows[i].insert(i);
    for (int k = 0; k < 3; ++k) {
      const int j = i + 1 + static_cast<int>(random.uniform(0, reach));
      if (j >= n) continue;
      rows[i].insert(j);
      if (k > 0) rows[j].insert(i);
    }
  }
  return rows;
}

BlockFill fill_of(const Pattern& rows) {
  std::vector<int> start{0}, column;
  for (const auto& row : rows) {
    column.insert(column.end(), row.begin(), row.end());
    start.push_back(static_cast<int>(column.size()));
  }
  return block_fill(start, column);
}

/// Blocks right of the diagonal after elimination in the order of `fill`, row by row.
Pattern eliminated(const Pattern& rows, const BlockFill& fill) {
  Pattern upper(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const int j : rows[i]) {
      const int a = fill.place[i], b = fill.place[j];
      if (a != b) upper[std::min(a, b)].insert(std::max(a, b));
    }
  for (const auto& row : upper)
    for (const int j : row) upper[j].insert(std::next(row.find(j)), row.end());
  return upper;
}

TEST(BlockFill, IsWhatEliminationFills) {
  int with_both_parts = 0;
  for (const auto& [n, reach] : {std::pair{1, 1}, {5, 1}, {40, 4}, {120, 60}, {300, 25}, {300, 300}}) {
    const Pattern rows = band(n, reach, static_cast<std::uint64_t>(n));
    const BlockFill fill = fill_of(rows);
    const Pattern truth = eliminated(rows, fill);
    ASSERT_EQ(fill.size(), n);
    for (int k = 0; k < n; ++k) {
      EXPECT_EQ(fill.place[fill.source[k]], k);
      const auto upper = fill.upper[k], lower = fill.lower[k];
      const auto& row = truth[k];
      if (k < fill.tail) {
        EXPECT_TRUE(std::equal(upper.begin(), upper.end(), row.begin(), row.end())) << n << " row " << k;
      }
      std::vector<int> left;
      for (int j = 0; j < std::min(k, fill.tail); ++j)
        if (truth[j].contains(k)) left.push_back(j);
      EXPECT_TRUE(std::equal(lower.begin(), lower.end(), left.begin(), left.end())) << n << " row " << k;
    }
    with_both_parts += fill.tail > 0 && fill.tail < n ? 1 : 0;
  }
  EXPECT_GT(with_both_parts, 0);
}

}  // namespace block_fill_test
}  // namespace nilas::contact
