#pragma once
/// The order in which the nodes of an island are eliminated, the blocks that this fills, and where each product goes:
/// all that a factorisation needs besides its numbers, made once per pattern.
///
/// Blocks lie below the diagonal, column by column. Column j holds rows[start[j] .. start[j + 1]), rising. Its products
/// go to the diagonal block of each row s of the column, and for each later row t to the block (t, s), whose place is
/// a number of `target`. Order and fill are those of contact/problem/block_fill.h.
///
/// A column gathers the products of those before it in their order, so that the bits do not depend on who does which
/// column when. Tasks are lists of columns that only need columns of their own task or of tasks before it.
#include <cstddef>
#include <optional>
#include <vector>

#include "contact/solvers/bodies/body_island.h"

namespace nilas::solvers {

/// A block that a row holds before its diagonal.
struct EarlierBlock {
  std::size_t place = 0;
  std::size_t target = 0;  ///< where the targets of its products with the later blocks of its column begin
  int column = 0;
};

/// A side on the node of a column, by its place among all sides, with its contact. Its pairs end at `last_pair`.
struct ColumnSide {
  int contact = 0, side = 0, last_pair = 0;
};

/// Another side of the same contact, on the node of a later column, and the block of both.
struct ColumnPair {
  int block = 0, side = 0;
  bool comes_first = false;  ///< among the sides of its contact
};

struct NodePlan {
  std::vector<int> place;   ///< place of each node in the order of elimination
  std::vector<int> source;  ///< the inverse of that
  std::vector<std::size_t> start{0};
  std::vector<int> rows;
  std::vector<int> target;
  std::vector<std::size_t> earlier_start{0};  ///< first of the earlier blocks of each row
  std::vector<EarlierBlock> earlier;          ///< by row, and in the order of their columns
  std::vector<int> task_start{0};             ///< first column of each task in `task_columns`
  std::vector<int> task_columns;              ///< rising in each task
  int num_pieces = 0;                         ///< of the tasks, those of subtrees, which need no others
  std::vector<int> task_of;                   ///< of each column
  std::vector<std::size_t> side_start{0};     ///< first of the sides of each column
  std::vector<ColumnSide> sides;              ///< by column, and in the order of contacts
  std::vector<ColumnPair> pairs;              ///< of all sides in their order
  double products = 0;                        ///< of two blocks below the diagonal, in one elimination

  int size() const { return static_cast<int>(place.size()); }
  std::size_t num_blocks() const { return rows.size(); }
  int num_tasks() const { return static_cast<int>(task_start.size()) - 1; }
};

/// Nothing where the elimination fills more than a million blocks (288 MB) or takes more than 20 million products of
/// blocks (a second or so), as in great heaps. A jam of 3900 floes takes 5e4 products, 3000 floes that touch on all
/// sides 7e5.
std::optional<NodePlan> plan_nodes(const BodyIsland& island);

/// Returns the products of two blocks in one elimination of the same nodes, of which only the marked contacts join any.
/// `joins`: one mark per contact.
double num_products(const BodyIsland& island, const std::vector<char>& joins);

}  // namespace nilas::solvers
