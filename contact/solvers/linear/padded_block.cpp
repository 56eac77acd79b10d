#include "contact/solvers/linear/padded_block.h"

#include <cstring>

#include "contact/solvers/linear/wide_clones.h"

namespace nilas::solvers {

namespace {

using Four = double __attribute__((vector_size(32)));

}  // namespace

NILAS_WIDE_CLONES PaddedBlock product(const PaddedBlock& a, const PaddedBlock& b) {
  Four left[3];
  std::memcpy(left, a.column, sizeof left);
  PaddedBlock out;
  for (int k = 0; k < 3; ++k) {
    const Four sum = left[0] * b.column[k][0] + left[1] * b.column[k][1] + left[2] * b.column[k][2];
    std::memcpy(out.column[k], &sum, sizeof sum);
  }
  return out;
}

NILAS_WIDE_CLONES void subtract_products(const PaddedBlock& factor, const PaddedBlock* blocks, const int* columns,
                                         std::size_t count, PaddedBlock* row) {
  Four f[3];
  std::memcpy(f, factor.column, sizeof f);
  for (std::size_t j = 0; j < count; ++j) {
    auto& target = row[columns[j]].column;
    const auto& block = blocks[j].column;
    for (int k = 0; k < 3; ++k) {
      Four sum;
      std::memcpy(&sum, target[k], sizeof sum);
      sum -= f[0] * block[k][0] + f[1] * block[k][1] + f[2] * block[k][2];
      std::memcpy(target[k], &sum, sizeof sum);
    }
  }
}

}  // namespace nilas::solvers
