#include "contact/problem/block_fill.h"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <limits>
#include <numeric>

namespace nilas::contact {

namespace {

/// The dense part begins where at least this share of the blocks to come are filled.
constexpr double k_dense_share = 0.95;
/// Least and most rows of a dense part. Fewer rows save nothing; more would take over half a gigabyte.
constexpr int k_smallest_tail = 8, k_largest_tail = 2500;

void order(const std::vector<int>& row_start, const std::vector<int>& column, BlockFill& fill) {
  const int n = static_cast<int>(row_start.size()) - 1;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(column.size());
  for (int i = 0; i < n; ++i)
    for (int k = row_start[i]; k < row_start[i + 1]; ++k) entries.emplace_back(i, column[k], 1.0);
  Eigen::SparseMatrix<double> pattern(n, n);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(pattern, permutation);
  // Eigen hands out the inverse permutation: entry k is the row that comes k-th
  fill.source.assign(permutation.indices().data(), permutation.indices().data() + n);
  fill.place.resize(n);
  for (int k = 0; k < n; ++k) fill.place[fill.source[k]] = k;
}

/// Returns n lists from `for_each`, which calls its argument for every (list, item), in the same order each time.
template <class ForEach>
ColumnLists lists_of(int n, const ForEach& for_each) {
  ColumnLists lists;
  lists.start.assign(n + 1, 0);
  for_each([&](int list, int) { ++lists.start[list + 1]; });
  std::partial_sum(lists.start.begin(), lists.start.end(), lists.start.begin());
  lists.columns.resize(lists.start.back());
  auto next = lists.start;
  for_each([&](int list, int item) { lists.columns[next[list]++] = item; });
  return lists;
}

/// Lists, for each row in the order of elimination, the blocks right of the diagonal that are given on either side of
/// it; unsorted.
ColumnLists given_upper(const std::vector<int>& row_start, const std::vector<int>& column, const BlockFill& fill) {
  return lists_of(fill.size(), [&](const auto& use) {
    for (int i = 0; i < fill.size(); ++i)
      for (int k = row_start[i]; k < row_start[i + 1]; ++k) {
        const int a = fill.place[i], b = fill.place[column[k]];
        if (a != b) use(std::min(a, b), std::max(a, b));
      }
  });
}

/// upper[k] = neighbours of k that come later, and those of every row whose first later neighbour is k. False when
/// these are more than `most` in all; then the lists are not complete.
bool find_fill(const ColumnLists& given, std::size_t most, BlockFill& fill) {
  const int n = fill.size();
  std::vector<int> first_child(n, -1), sibling(n, -1), seen(n, -1);
  auto& columns = fill.upper.columns;
  const auto take = [&](int j, int k) {
    if (seen[j] == k) return;
    seen[j] = k;
    columns.push_back(j);
  };
  for (int k = 0; k < n; ++k) {
    seen[k] = k;
    for (const int j : given[k]) take(j, k);
    for (int child = first_child[k]; child >= 0; child = sibling[child])
      for (std::size_t i = fill.upper.first(child); i < fill.upper.first(child + 1); ++i) take(columns[i], k);
    const auto row = columns.begin() + static_cast<std::ptrdiff_t>(fill.upper.start.back());
    std::sort(row, columns.end());
    if (row != columns.end()) {
      sibling[k] = first_child[*row];
      first_child[*row] = k;
    }
    fill.upper.start.push_back(columns.size());
    if (columns.size() > most) return false;
  }
  return true;
}

void choose_tail(BlockFill& fill) {
  const int n = fill.size();
  fill.tail = n;
  double filled = 0;
  for (int k = n - 1; k >= 0; --k) {
    filled += static_cast<double>(fill.upper[k].size());
    const double rows = n - k;
    if (rows > k_largest_tail) break;
    if (rows >= k_smallest_tail && filled >= k_dense_share * rows * (rows - 1) / 2) fill.tail = k;
  }
}

/// Removes blocks inside the dense part from the lists.
void drop_tail(BlockFill& fill) {
  fill.upper.columns.resize(fill.upper.first(fill.tail));
  std::fill(fill.upper.start.begin() + fill.tail, fill.upper.start.end(), fill.upper.columns.size());
}

ColumnLists lower_of(const BlockFill& fill) {
  return lists_of(fill.size(), [&](const auto& use) {
    for (int k = 0; k < fill.tail; ++k)
      for (const int j : fill.upper[k]) use(j, k);
  });
}

}  // namespace

BlockFill block_fill(const std::vector<int>& row_start, const std::vector<int>& column, DenseTail tail) {
  BlockFill fill;
  order(row_start, column, fill);
  find_fill(given_upper(row_start, column, fill), std::numeric_limits<std::size_t>::max(), fill);
  fill.tail = fill.size();
  if (tail == DenseTail::where_it_pays) choose_tail(fill);
  drop_tail(fill);
  fill.lower = lower_of(fill);
  return fill;
}

bool fills_at_most(std::size_t blocks, const std::vector<int>& row_start, const std::vector<int>& column) {
  BlockFill fill;
  order(row_start, column, fill);
  return find_fill(given_upper(row_start, column, fill), blocks, fill);
}

}  // namespace nilas::contact
