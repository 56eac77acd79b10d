#pragma once
/// The velocities of one island's blocks, gathered block by block, so that blocks may be done at once.
#include <vector>

#include "contact/solvers/shared/row_islands.h"

namespace nilas::solvers {

class BlockSums {
 public:
  /// `order_free`: the bits do not depend on the order of contacts or bodies, and mirror images stay mirror images.
  BlockSums(const RowIsland& island, bool order_free);

  /// rows.velocities of the island's blocks = their velocities without contact + the response to the impulses r (3 per
  /// contact of the island).
  void set_velocities(const VecX& r);

 private:
  /// One side of one contact.
  struct Side {
    int contact;             ///< contact of the island
    int stride;              ///< numbers from row to row
    Eigen::Index responses;  ///< index into PgsRows::coefficients
  };
  struct Block {
    int first, size;            ///< range in PgsRows::velocities
    int first_side, last_side;  ///< range in sides_
    std::ptrdiff_t first_free;  ///< first entry in free_
  };

  void list_sides();
  template <int N>
  void gather(const Block& block, const VecX& r, double* z) const;
  void gather_order_free(const Block& block, const VecX& r, double* z) const;
  double term(const Side& side, int j, const VecX& r) const;

  RowIsland island_;
  bool order_free_;
  int rows_;  ///< rows per contact, 1 without friction
  std::vector<Block> blocks_;
  std::vector<Side> sides_;
  std::vector<double> free_;
};

}  // namespace nilas::solvers
