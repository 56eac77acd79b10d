#pragma once
/// The rows of one contact on the velocities of its two blocks, unrolled for blocks of known size.
#include "contact/solvers/shared/pgs_rows.h"

namespace nilas::solvers {

/// A block size that only the problem knows.
constexpr int k_any = Eigen::Dynamic;

template <int N>
using Numbers = Eigen::Map<const Eigen::Matrix<double, N, 1>, N == k_any ? Eigen::Unaligned : Eigen::Aligned16>;
template <int N>
using Velocities = Eigen::Map<Eigen::Matrix<double, N, 1>, N == k_any ? Eigen::Unaligned : Eigen::Aligned16>;

/// The two blocks of one contact. NA, NB: sizes known to the compiler (6 or 0), or k_any.
template <int NA, int NB>
class Sides {
 public:
  Sides(const PgsContact& contact, const double* coefficients, double* velocities)
      : rows_(coefficients + contact.rows),
        responses_(coefficients + contact.responses),
        a_(velocities + contact.first_a),
        b_(velocities + contact.first_b),
        n_a_(NA == k_any ? contact.size_a : NA),
        n_b_(NB == k_any ? contact.size_b : NB) {}

  /// Row i of J_A v_A + J_B v_B.
  [[gnu::always_inline]] double velocity(Eigen::Index i) const {
    const double* const row = rows_ + i * (n_a_ + n_b_);
    if constexpr (NA > 0 && NB > 0)
      return (Numbers<NA>(row).cwiseProduct(Numbers<NA>(a_)) + Numbers<NB>(row + NA).cwiseProduct(Numbers<NB>(b_)))
          .sum();
    double sum = 0;
    if constexpr (NA != 0) sum += times<NA>(row, a_, n_a_);
    if constexpr (NB != 0) sum += times<NB>(row + n_a_, b_, n_b_);
    return sum;
  }

  [[gnu::always_inline]] void apply_normal(double dn) const {
    const double* const y = responses_;
    if constexpr (NA != 0) Velocities<NA>(a_, n_a_) += dn * Numbers<NA>(y, n_a_);
    if constexpr (NB != 0) Velocities<NB>(b_, n_b_) += dn * Numbers<NB>(y + n_a_, n_b_);
  }

  [[gnu::always_inline]] void apply(double dn, double d1, double d2) const {
    if constexpr (NA != 0) add<NA>(dn, d1, d2, responses_, n_a_, a_);
    if constexpr (NB != 0) add<NB>(dn, d1, d2, responses_ + n_a_, n_b_, b_);
  }

 private:
  // For blocks of a rigid body as plain loops: the compiler leaves the general expressions uninlined in visits. The
  // order of their sums is the same.
  template <int N>
  [[gnu::always_inline]] static double times(const double* row, const double* v, Eigen::Index n) {
    if constexpr (N == 6)
      return (row[0] * v[0] + (row[2] * v[2] + row[4] * v[4])) + (row[1] * v[1] + (row[3] * v[3] + row[5] * v[5]));
    else
      return Numbers<N>(row, n).dot(Numbers<N>(v, n));
  }
  template <int N>
  [[gnu::always_inline]] void add(double dn, double d1, double d2, const double* y, Eigen::Index n, double* v) const {
    const Eigen::Index stride = n_a_ + n_b_;
    const double *const y1 = y + stride, *const y2 = y1 + stride;
    if constexpr (N == 6)
      for (int k = 0; k < N; ++k) v[k] += dn * y[k] + d1 * y1[k] + d2 * y2[k];
    else
      Velocities<N>(v, n) += dn * Numbers<N>(y, n) + d1 * Numbers<N>(y1, n) + d2 * Numbers<N>(y2, n);
  }

  const double* rows_;
  const double* responses_;
  double* a_;
  double* b_;
  Eigen::Index n_a_, n_b_;
};

}  // namespace nilas::solvers
