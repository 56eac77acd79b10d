#pragma once
/// The solution of a linear system to so many digits that rounding it gives the same bits however it was factorised.
///
///   d_k = K^-1 (b - K x_k) by the factors,  x_k+1 = x_k + d_k,  until |d_k| <= 2^-66 |x|
///
/// x is kept as the sum of two doubles and the remainder is taken in twice the precision, so each round gains as many
/// digits as the factors are good for. The result is x rounded to multiples of 2^-36 of the power of two below its
/// largest component. What the order of elimination leaves in x lies twelve digits below that multiple, so permuted and
/// mirrored systems give the same bits unless a component lies that near to the middle of two multiples.
/// Source: Ogita, Rump, Oishi 2005 (products in twice the precision).
#include <vector>

#include "contact/solvers/linear/block_lu.h"

namespace nilas::solvers {

/// A sparse matrix of 3 x 3 blocks: row i has `block[k]` at `column[k]` for k in row_start[i] .. row_start[i + 1] - 1.
struct BlockRows {
  const std::vector<int>& row_start;
  const std::vector<int>& column;
  const std::vector<Mat3>& block;
};

/// x <- K^-1 x, rounded. `factors`: of the same matrix. False where the remainder does not shrink so far: the matrix
/// is singular, or nearly.
bool solve_rounded(const BlockRows& matrix, const BlockLu& factors, VecX& x);

}  // namespace nilas::solvers
