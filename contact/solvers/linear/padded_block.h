#pragma once
/// 3 x 3 numbers laid out for vector registers, and the one loop over them where block factorisations spend their time.
#include <cstddef>

#include "core/base/math.h"

namespace nilas::solvers {

/// A 3 x 3 block by columns, each padded to four numbers so that it fills whole registers. The pads stay zero.
struct alignas(32) PaddedBlock {
  double column[3][4] = {};

  PaddedBlock() = default;
  explicit PaddedBlock(const Mat3& m) {
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) column[j][i] = m(i, j);
  }
  Eigen::Map<const Mat3, Eigen::Unaligned, Eigen::OuterStride<4>> matrix() const {
    return Eigen::Map<const Mat3, Eigen::Unaligned, Eigen::OuterStride<4>>(&column[0][0]);
  }
};

/// a * b.
PaddedBlock product(const PaddedBlock& a, const PaddedBlock& b);
/// row[columns[j]] -= factor * blocks[j] for `count` blocks, about 5 ns each.
void subtract_products(const PaddedBlock& factor, const PaddedBlock* blocks, const int* columns, std::size_t count,
                       PaddedBlock* row);

}  // namespace nilas::solvers
