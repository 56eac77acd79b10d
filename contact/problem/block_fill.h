#pragma once
/// Finds the order in which the rows of a sparse matrix of 3 x 3 blocks are eliminated, and the blocks that this fills.
/// The pattern is made symmetric. The last rows, where fill leaves few zeros, form one dense matrix, because in
/// three-dimensional packings most of the work lies there. Sources: Liu 1990 (elimination trees); Amestoy, Davis, Duff
/// 1996 (approximate minimum degree, Eigen's code).
#include <cstddef>
#include <span>
#include <vector>

namespace nilas::contact {

/// Lists of columns, one per row, one after the other in memory.
struct ColumnLists {
  std::vector<std::size_t> start{0};
  std::vector<int> columns;

  std::span<const int> operator[](int row) const {
    return std::span(columns).subspan(first(row), first(row + 1) - first(row));
  }
  std::size_t first(int row) const { return start[row]; }
};

struct BlockFill {
  std::vector<int> place;   ///< place of each given row in the order of elimination
  std::vector<int> source;  ///< the inverse of that
  ColumnLists upper;        ///< right of the diagonal, rising; of rows before the tail
  ColumnLists lower;        ///< left of the diagonal and before the tail, rising
  int tail = 0;             ///< first row of the dense part

  int size() const { return static_cast<int>(place.size()); }
};

/// Whether the last rows are taken as one dense matrix where that saves work.
enum class DenseTail { where_it_pays, none };

/// Returns order and fill of the matrix whose row i has blocks at `column[row_start[i] .. row_start[i + 1])`.
BlockFill block_fill(const std::vector<int>& row_start, const std::vector<int>& column,
                     DenseTail tail = DenseTail::where_it_pays);

/// Whether elimination fills at most so many blocks right of the diagonal, the dense part's included. Repeated columns
/// are allowed here.
bool fills_at_most(std::size_t blocks, const std::vector<int>& row_start, const std::vector<int>& column);

}  // namespace nilas::contact
