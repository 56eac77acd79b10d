#pragma once
/// Products of blocks and rows of nodes. They are inlined into loops that are compiled for wide registers, and hold
/// what they use most in registers of eight numbers, a padded column, or of four.
#include "contact/solvers/bodies/node_block.h"
#include "contact/solvers/linear/wide_clones.h"

namespace nilas::solvers {

using FourNumbers = double __attribute__((vector_size(32), may_alias));
using EightNumbers = double __attribute__((vector_size(64), may_alias));
/// Registers of a padded column.
template <class Numbers>
constexpr int k_parts = k_node_width* static_cast<int>(sizeof(double)) / static_cast<int>(sizeof(Numbers));

/// target -= a b^T
template <class Numbers>
NILAS_PART_OF_CLONES void subtract_product(const NodeBlock& a, const NodeBlock& b, NodeBlock& target) {
  for (int part = 0; part < k_parts<Numbers>; ++part) {
    const auto column = [&](int k) { return reinterpret_cast<const Numbers*>(a.column[k]) + part; };
    const Numbers a0 = *column(0), a1 = *column(1), a2 = *column(2), a3 = *column(3), a4 = *column(4), a5 = *column(5);
    for (int j = 0; j < k_node_size; ++j) {
      Numbers* const out = reinterpret_cast<Numbers*>(target.column[j]) + part;
      *out -= ((a0 * b.column[0][j] + a1 * b.column[1][j]) + (a2 * b.column[2][j] + a3 * b.column[3][j])) +
              (a4 * b.column[4][j] + a5 * b.column[5][j]);
    }
  }
}

/// y -= a x
template <class Numbers>
NILAS_PART_OF_CLONES void subtract_times(const NodeBlock& a, const double* x, double* y) {
  for (int part = 0; part < k_parts<Numbers>; ++part) {
    const auto column = [&](int k) { return reinterpret_cast<const Numbers*>(a.column[k]) + part; };
    *(reinterpret_cast<Numbers*>(y) + part) -=
        ((*column(0) * x[0] + *column(1) * x[1]) + (*column(2) * x[2] + *column(3) * x[3])) +
        (*column(4) * x[4] + *column(5) * x[5]);
  }
}

/// sum += a^T x
NILAS_PART_OF_CLONES void add_transposed_times(const NodeBlock& a, const double* x, double* sum) {
  for (int k = 0; k < k_node_size; ++k) {
    const double* const column = a.column[k];
    sum[k] += ((column[0] * x[0] + column[1] * x[1]) + (column[2] * x[2] + column[3] * x[3])) +
              (column[4] * x[4] + column[5] * x[5]);
  }
}

/// scaled = g rows
template <class Numbers>
NILAS_PART_OF_CLONES void multiply(const double (&g)[3][3], const NodeRows& rows, NodeRows& scaled) {
  for (int part = 0; part < k_parts<Numbers>; ++part) {
    const auto row = [&](int i) { return reinterpret_cast<const Numbers*>(rows.row[i]) + part; };
    const Numbers r0 = *row(0), r1 = *row(1), r2 = *row(2);
    for (int i = 0; i < 3; ++i)
      *(reinterpret_cast<Numbers*>(scaled.row[i]) + part) = r0 * g[i][0] + r1 * g[i][1] + r2 * g[i][2];
  }
}

/// block += x^T y: columns go with the coordinates of y.
template <class Numbers>
NILAS_PART_OF_CLONES void add_outer(const NodeRows& x, const NodeRows& y, NodeBlock& block) {
  for (int part = 0; part < k_parts<Numbers>; ++part) {
    const auto row = [&](int i) { return reinterpret_cast<const Numbers*>(x.row[i]) + part; };
    const Numbers r0 = *row(0), r1 = *row(1), r2 = *row(2);
    for (int k = 0; k < k_node_size; ++k)
      *(reinterpret_cast<Numbers*>(block.column[k]) + part) += r0 * y.row[0][k] + r1 * y.row[1][k] + r2 * y.row[2][k];
  }
}

/// b <- b scale, one column.
template <class Numbers>
NILAS_PART_OF_CLONES void scale_column(double scale, double* column) {
  for (int part = 0; part < k_parts<Numbers>; ++part) *(reinterpret_cast<Numbers*>(column) + part) *= scale;
}

/// column -= factor other
template <class Numbers>
NILAS_PART_OF_CLONES void subtract_column(double factor, const double* other, double* column) {
  for (int part = 0; part < k_parts<Numbers>; ++part)
    *(reinterpret_cast<Numbers*>(column) + part) -= factor * *(reinterpret_cast<const Numbers*>(other) + part);
}

}  // namespace nilas::solvers
