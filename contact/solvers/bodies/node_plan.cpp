#include "contact/solvers/bodies/node_plan.h"

#include <algorithm>

#include "contact/problem/block_fill.h"

namespace nilas::solvers {

namespace {

constexpr std::size_t k_most_blocks = 1000000;
/// A jam of 3900 floes has 5e4 products. Where there are many more, W is factorised in less time, since open contacts
/// are not part of it.
constexpr double k_most_products = 5e5;

/// The nodes that each node shares a contact with, itself among them, as the rows of a matrix.
void pattern_of(const BodyIsland& island, std::vector<int>& row_start, std::vector<int>& column) {
  std::vector<std::vector<int>> lists(static_cast<std::size_t>(island.num_nodes()));
  for (int k = 0; k < island.num_nodes(); ++k) lists[k].push_back(k);
  for (int c = 0; c < island.num_contacts(); ++c) {
    const auto sides = island.sides(c);
    for (std::size_t s = 0; s < sides.size(); ++s)
      for (std::size_t t = s + 1; t < sides.size(); ++t) {
        lists[sides[s].node].push_back(sides[t].node);
        lists[sides[t].node].push_back(sides[s].node);
      }
  }
  row_start.assign(1, 0);
  for (auto& list : lists) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    column.insert(column.end(), list.begin(), list.end());
    row_start.push_back(static_cast<int>(column.size()));
  }
}

/// Place of the block of two nodes given by their places in the order.
int find_block(const NodePlan& plan, int a, int b) {
  const auto first = plan.rows.begin() + static_cast<std::ptrdiff_t>(plan.start[std::min(a, b)]);
  const auto last = plan.rows.begin() + static_cast<std::ptrdiff_t>(plan.start[std::min(a, b) + 1]);
  return static_cast<int>(std::lower_bound(first, last, std::max(a, b)) - plan.rows.begin());
}

/// Products of two blocks below the diagonal in one elimination.
double num_products(const NodePlan& plan) {
  double sum = 0;
  for (int j = 0; j < plan.size(); ++j) {
    const auto m = static_cast<double>(plan.start[j + 1] - plan.start[j]);
    sum += 0.5 * m * (m + 1);
  }
  return sum;
}

void find_targets(NodePlan& plan) {
  for (int j = 0; j < plan.size(); ++j) {
    const std::size_t last = plan.start[j + 1];
    for (std::size_t s = plan.start[j]; s < last; ++s) {
      std::size_t at = plan.start[plan.rows[s]];
      for (std::size_t t = s + 1; t < last; ++t) {
        while (plan.rows[at] != plan.rows[t]) ++at;
        plan.target.push_back(static_cast<int>(at));
      }
    }
    plan.target_start.push_back(plan.target.size());
  }
}

}  // namespace

std::optional<NodePlan> plan_nodes(const BodyIsland& island) {
  std::vector<int> row_start, column;
  pattern_of(island, row_start, column);
  if (!contact::fills_at_most(k_most_blocks, row_start, column)) return {};
  contact::BlockFill fill = contact::block_fill(row_start, column, contact::DenseTail::none);
  NodePlan plan;
  plan.place = std::move(fill.place);
  plan.source = std::move(fill.source);
  plan.start = std::move(fill.upper.start);
  plan.rows = std::move(fill.upper.columns);
  if (num_products(plan) > k_most_products) return {};
  find_targets(plan);
  for (int c = 0; c < island.num_contacts(); ++c) {
    const auto sides = island.sides(c);
    for (std::size_t s = 0; s < sides.size(); ++s)
      for (std::size_t t = s + 1; t < sides.size(); ++t)
        plan.pair.push_back(find_block(plan, plan.place[sides[s].node], plan.place[sides[t].node]));
    plan.pair_start.push_back(plan.pair.size());
  }
  return plan;
}

}  // namespace nilas::solvers
