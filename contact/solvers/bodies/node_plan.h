#pragma once
/// The order in which the nodes of an island are eliminated, the blocks that this fills, and where each product goes:
/// all that a factorisation needs besides its numbers, made once per pattern.
///
/// Blocks lie below the diagonal, column by column. Column j holds rows[start[j] .. start[j + 1]), rising. Its products
/// go to the diagonal block of each row s of the column, and for each later row t to the block (t, s), whose place is
/// the next number of `target`. Order and fill are those of contact/problem/block_fill.h.
#include <cstddef>
#include <optional>
#include <vector>

#include "contact/solvers/bodies/body_island.h"

namespace nilas::solvers {

struct NodePlan {
  std::vector<int> place;   ///< place of each node in the order of elimination
  std::vector<int> source;  ///< the inverse of that
  std::vector<std::size_t> start{0};
  std::vector<int> rows;
  std::vector<std::size_t> target_start{0};  ///< first target of each column
  std::vector<int> target;
  std::vector<std::size_t> pair_start{0};  ///< first pair of each contact
  std::vector<int> pair;  ///< place of the block between every two sides of a contact, the first with each later one

  int size() const { return static_cast<int>(place.size()); }
  std::size_t num_blocks() const { return rows.size(); }
};

/// Nothing where the elimination fills more than a million blocks or takes more than 30 million products of blocks, as
/// in great heaps: 0.4 GB per factor and seconds per factorisation.
std::optional<NodePlan> plan_nodes(const BodyIsland& island);

}  // namespace nilas::solvers
