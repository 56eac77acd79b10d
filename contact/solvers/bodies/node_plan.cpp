#include "contact/solvers/bodies/node_plan.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "contact/problem/block_fill.h"

namespace nilas::solvers {

namespace {

constexpr std::size_t k_most_blocks = 1000000;
constexpr double k_most_products = 2e7;
/// What a column takes besides its products of blocks, in such products.
constexpr double k_work_of_column = 8;
/// Of all products, the most in a task of several columns.
constexpr double k_share_of_task = 1.0 / 12;

/// A square pattern by rows.
struct Pattern {
  std::vector<int> row_start{0}, column;
};

/// The nodes that each node shares a marked contact with, itself among them.
Pattern pattern_of(const BodyIsland& island, const std::vector<char>& joins) {
  Pattern pattern;
  std::vector<std::vector<int>> lists(static_cast<std::size_t>(island.num_nodes()));
  for (int k = 0; k < island.num_nodes(); ++k) lists[k].push_back(k);
  for (int c = 0; c < island.num_contacts(); ++c) {
    if (joins[c] == 0) continue;
    for (int s = island.first_side(c); s < island.first_side(c + 1); ++s)
      for (int t = s + 1; t < island.first_side(c + 1); ++t) {
        lists[island.node(s)].push_back(island.node(t));
        lists[island.node(t)].push_back(island.node(s));
      }
  }
  for (auto& list : lists) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    pattern.column.insert(pattern.column.end(), list.begin(), list.end());
    pattern.row_start.push_back(static_cast<int>(pattern.column.size()));
  }
  return pattern;
}

/// Place of the block of two nodes given by their places in the order.
int find_block(const NodePlan& plan, int a, int b) {
  const auto first = plan.rows.begin() + static_cast<std::ptrdiff_t>(plan.start[std::min(a, b)]);
  const auto last = plan.rows.begin() + static_cast<std::ptrdiff_t>(plan.start[std::min(a, b) + 1]);
  return static_cast<int>(std::lower_bound(first, last, std::max(a, b)) - plan.rows.begin());
}

/// Nothing where too much is filled.
std::optional<contact::BlockFill> fill_of(const Pattern& pattern) {
  if (!contact::fills_at_most(k_most_blocks, pattern.row_start, pattern.column)) return {};
  return contact::block_fill(pattern.row_start, pattern.column, contact::DenseTail::none);
}

double products_of(const contact::BlockFill& fill) {
  double sum = 0;
  for (int j = 0; j < fill.size(); ++j) {
    const auto m = static_cast<double>(fill.upper[j].size());
    sum += 0.5 * m * (m + 1);
  }
  return sum;
}

void find_targets(NodePlan& plan) {
  plan.earlier_start.assign(static_cast<std::size_t>(plan.size()) + 1, 0);
  for (const int row : plan.rows) ++plan.earlier_start[row + 1];
  for (int j = 0; j < plan.size(); ++j) plan.earlier_start[j + 1] += plan.earlier_start[j];
  std::vector<std::size_t> next(plan.earlier_start.begin(), plan.earlier_start.end() - 1);
  plan.earlier.resize(plan.num_blocks());
  for (int j = 0; j < plan.size(); ++j) {
    const std::size_t last = plan.start[j + 1];
    for (std::size_t s = plan.start[j]; s < last; ++s) {
      plan.earlier[next[plan.rows[s]]++] = {s, plan.target.size(), j};
      std::size_t at = plan.start[plan.rows[s]];
      for (std::size_t t = s + 1; t < last; ++t) {
        while (plan.rows[at] != plan.rows[t]) ++at;
        plan.target.push_back(static_cast<int>(at));
      }
    }
  }
}

/// Makes one task of each largest subtree of the elimination tree that takes at most a share of the products, with the
/// columns of small ones put together, and one of each column above them. The number of threads plays no part.
void find_tasks(NodePlan& plan) {
  std::vector<double> work(static_cast<std::size_t>(plan.size()));
  std::vector<int> parent(work.size(), -1);
  double all = 0;
  for (int j = 0; j < plan.size(); ++j) {
    const std::size_t m = plan.start[j + 1] - plan.start[j];
    const double own = k_work_of_column + 0.5 * static_cast<double>(m * (m + 1));
    all += own;
    work[j] += own;  // of the columns below too, which come first
    if (m == 0) continue;
    parent[j] = plan.rows[plan.start[j]];
    work[parent[j]] += work[j];
  }
  const double most = k_share_of_task * all;
  std::vector<int> piece(work.size(), -1);
  int pieces = 0;
  double filled = most;
  for (int j = plan.size() - 1; j >= 0; --j) {
    if (work[j] > most) continue;
    if (parent[j] >= 0 && piece[parent[j]] >= 0) {
      piece[j] = piece[parent[j]];
      continue;
    }
    if (filled + work[j] > most) {
      ++pieces;
      filled = 0;
    }
    filled += work[j];
    piece[j] = pieces - 1;
  }
  plan.num_pieces = pieces;
  plan.task_of.resize(work.size());
  for (int j = 0, above = pieces; j < plan.size(); ++j)
    plan.task_of[j] = piece[j] >= 0 ? pieces - 1 - piece[j] : above++;
  plan.task_columns.resize(work.size());
  std::iota(plan.task_columns.begin(), plan.task_columns.end(), 0);
  std::stable_sort(plan.task_columns.begin(), plan.task_columns.end(),
                   [&](int a, int b) { return plan.task_of[a] < plan.task_of[b]; });
  for (int k = 1; k <= plan.size(); ++k)
    if (k == plan.size() || plan.task_of[plan.task_columns[k]] != plan.task_of[plan.task_columns[k - 1]])
      plan.task_start.push_back(k);
}

void find_sides(const BodyIsland& island, NodePlan& plan) {
  for (int j = 0; j < plan.size(); ++j) {
    for (const NodeEntry& entry : island.entries(plan.source[j])) {
      for (int t = island.first_side(entry.contact); t < island.first_side(entry.contact + 1); ++t)
        if (const int other = plan.place[island.node(t)]; other > j)
          plan.pairs.push_back({find_block(plan, j, other), t, t < entry.side});
      plan.sides.push_back({entry.contact, entry.side, static_cast<int>(plan.pairs.size())});
    }
    plan.side_start.push_back(plan.sides.size());
  }
}

}  // namespace

std::optional<NodePlan> plan_nodes(const BodyIsland& island) {
  const std::vector<char> all(static_cast<std::size_t>(island.num_contacts()), 1);
  std::optional<contact::BlockFill> fill = fill_of(pattern_of(island, all));
  if (!fill) return {};
  NodePlan plan;
  plan.products = products_of(*fill);
  if (plan.products > k_most_products) return {};
  plan.place = std::move(fill->place);
  plan.source = std::move(fill->source);
  plan.start = std::move(fill->upper.start);
  plan.rows = std::move(fill->upper.columns);
  find_targets(plan);
  find_tasks(plan);
  find_sides(island, plan);
  return plan;
}

double num_products(const BodyIsland& island, const std::vector<char>& joins) {
  const auto fill = fill_of(pattern_of(island, joins));
  return fill ? products_of(*fill) : std::numeric_limits<double>::infinity();
}

}  // namespace nilas::solvers
