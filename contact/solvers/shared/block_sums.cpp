#include "contact/solvers/shared/block_sums.h"

#include <algorithm>

#include "core/base/order_free_sum.h"
#include "core/base/parallel.h"

namespace nilas::solvers {

BlockSums::BlockSums(const RowIsland& island, bool order_free)
    : island_(island), order_free_(order_free), rows_(island.problem.law == Law::frictionless ? 1 : 3) {
  const contact::ContactProblem& problem = island.problem;
  for (const int k : island.island.blocks) {
    const auto i = static_cast<std::size_t>(k);
    blocks_.push_back(
        {island.rows.first_velocity[i], problem.block_size(k), 0, 0, static_cast<std::ptrdiff_t>(free_.size())});
    set_block_velocities(island.masses, k, problem.f.data() + problem.block_offset[i], island.rows);
    const auto own = island.rows.velocities.segment(blocks_.back().first, blocks_.back().size);
    free_.insert(free_.end(), own.begin(), own.end());
  }
  list_sides();
}

void BlockSums::list_sides() {
  std::vector<int> place(static_cast<std::size_t>(island_.problem.num_blocks()), -1);
  for (std::size_t b = 0; b < island_.island.blocks.size(); ++b) place[island_.island.blocks[b]] = static_cast<int>(b);
  const auto visit = [&](const auto& call) {
    for (int k = island_.island.first; k < island_.island.last; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const PgsContact& contact = island_.rows.contacts[i];
      const auto& pair = island_.problem.pairs[island_.rows.source[i]];
      const int c = k - island_.island.first, stride = contact.stride();
      if (pair.a >= 0) call(place[pair.a], Side{c, stride, contact.responses});
      if (pair.b >= 0) call(place[pair.b], Side{c, stride, contact.responses + contact.size_a});
    }
  };
  visit([&](int b, const Side&) { ++blocks_[b].last_side; });
  int first = 0;
  for (Block& block : blocks_) {
    block.first_side = first;
    first += block.last_side;
    block.last_side = block.first_side;
  }
  sides_.resize(static_cast<std::size_t>(first));
  visit([&](int b, const Side& side) { sides_[blocks_[b].last_side++] = side; });
}

void BlockSums::set_velocities(const VecX& r) {
  parallel_for(static_cast<std::ptrdiff_t>(blocks_.size()), island_.threads, [&](std::ptrdiff_t k) {
    const Block& block = blocks_[k];
    double* const z = island_.rows.velocities.data() + block.first;
    std::copy_n(free_.data() + block.first_free, block.size, z);
    if (order_free_)
      gather_order_free(block, r, z);
    else if (block.size == 6)
      gather<6>(block, r, z);
    else
      gather<Eigen::Dynamic>(block, r, z);
  });
}

template <int N>
void BlockSums::gather(const Block& block, const VecX& r, double* z) const {
  // a side may begin at any place, so nothing here is aligned
  using Column = Eigen::Matrix<double, N, 1>;
  const double* const coefficients = island_.rows.coefficients.data();
  Eigen::Map<Column> sum(z, block.size);
  for (int k = block.first_side; k < block.last_side; ++k) {
    const Side& side = sides_[k];
    const double* const own = r.data() + 3 * static_cast<std::ptrdiff_t>(side.contact);
    if (own[0] == 0 && own[1] == 0 && own[2] == 0) continue;
    const auto row = [&](int i) {
      return Eigen::Map<const Column>(coefficients + side.responses + i * side.stride, block.size);
    };
    if (rows_ == 1)
      sum += own[0] * row(0);
    else
      sum += own[0] * row(0) + own[1] * row(1) + own[2] * row(2);
  }
}

/// Returns what the contact adds to velocity j of the block on this side.
double BlockSums::term(const Side& side, int j, const VecX& r) const {
  const double* const own = r.data() + 3 * static_cast<std::ptrdiff_t>(side.contact);
  const double* const y = island_.rows.coefficients.data() + side.responses + j;
  return rows_ == 1 ? own[0] * y[0] : own[0] * y[0] + own[1] * y[side.stride] + own[2] * y[2 * side.stride];
}

void BlockSums::gather_order_free(const Block& block, const VecX& r, double* z) const {
  for (int j = 0; j < block.size; ++j) {
    OrderFreeSum sum;
    sum.add(z[j]);
    for (int k = block.first_side; k < block.last_side; ++k) sum.add(term(sides_[k], j, r));
    z[j] = sum.value();
  }
}

}  // namespace nilas::solvers
