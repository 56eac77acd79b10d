#pragma once
/// Products of blocks and rows of nodes. They are inlined into loops that are compiled for wide registers, and hold
/// what they use most in registers of four numbers: half a padded column.
#include "contact/solvers/bodies/node_block.h"

namespace nilas::solvers {

using FourNumbers = double __attribute__((vector_size(32), may_alias));
constexpr int k_halves = k_node_width / 4;

/// target -= a b^T
inline void subtract_product(const NodeBlock& a, const NodeBlock& b, NodeBlock& target) {
  for (int half = 0; half < k_halves; ++half) {
    const auto column = [&](int k) { return reinterpret_cast<const FourNumbers*>(a.column[k]) + half; };
    const FourNumbers a0 = *column(0), a1 = *column(1), a2 = *column(2), a3 = *column(3), a4 = *column(4),
                      a5 = *column(5);
    for (int j = 0; j < k_node_size; ++j) {
      FourNumbers* const out = reinterpret_cast<FourNumbers*>(target.column[j]) + half;
      *out -= ((a0 * b.column[0][j] + a1 * b.column[1][j]) + (a2 * b.column[2][j] + a3 * b.column[3][j])) +
              (a4 * b.column[4][j] + a5 * b.column[5][j]);
    }
  }
}

/// y -= a x
inline void subtract_times(const NodeBlock& a, const double* x, double* y) {
  for (int half = 0; half < k_halves; ++half) {
    const auto column = [&](int k) { return reinterpret_cast<const FourNumbers*>(a.column[k]) + half; };
    *(reinterpret_cast<FourNumbers*>(y) + half) -=
        ((*column(0) * x[0] + *column(1) * x[1]) + (*column(2) * x[2] + *column(3) * x[3])) +
        (*column(4) * x[4] + *column(5) * x[5]);
  }
}

/// sum += a^T x
inline void add_transposed_times(const NodeBlock& a, const double* x, double* sum) {
  for (int k = 0; k < k_node_size; ++k) {
    const double* const column = a.column[k];
    sum[k] += ((column[0] * x[0] + column[1] * x[1]) + (column[2] * x[2] + column[3] * x[3])) +
              (column[4] * x[4] + column[5] * x[5]);
  }
}

/// scaled = g rows
inline void multiply(const double (&g)[3][3], const NodeRows& rows, NodeRows& scaled) {
  for (int half = 0; half < k_halves; ++half) {
    const auto row = [&](int i) { return reinterpret_cast<const FourNumbers*>(rows.row[i]) + half; };
    const FourNumbers r0 = *row(0), r1 = *row(1), r2 = *row(2);
    for (int i = 0; i < 3; ++i)
      *(reinterpret_cast<FourNumbers*>(scaled.row[i]) + half) = r0 * g[i][0] + r1 * g[i][1] + r2 * g[i][2];
  }
}

/// block += x^T y: columns go with the coordinates of y.
inline void add_outer(const NodeRows& x, const NodeRows& y, NodeBlock& block) {
  for (int half = 0; half < k_halves; ++half) {
    const auto row = [&](int i) { return reinterpret_cast<const FourNumbers*>(x.row[i]) + half; };
    const FourNumbers r0 = *row(0), r1 = *row(1), r2 = *row(2);
    for (int k = 0; k < k_node_size; ++k)
      *(reinterpret_cast<FourNumbers*>(block.column[k]) + half) +=
          r0 * y.row[0][k] + r1 * y.row[1][k] + r2 * y.row[2][k];
  }
}

/// b <- b scale, one column.
inline void scale_column(double scale, double* column) {
  for (int half = 0; half < k_halves; ++half) *(reinterpret_cast<FourNumbers*>(column) + half) *= scale;
}

/// column -= factor other
inline void subtract_column(double factor, const double* other, double* column) {
  for (int half = 0; half < k_halves; ++half)
    *(reinterpret_cast<FourNumbers*>(column) + half) -= factor * *(reinterpret_cast<const FourNumbers*>(other) + half);
}

}  // namespace nilas::solvers
