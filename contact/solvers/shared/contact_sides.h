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
    if constexpr (NA != 0) sum += Numbers<NA>(row, n_a_).dot(Numbers<NA>(a_, n_a_));
    if constexpr (NB != 0) sum += Numbers<NB>(row + n_a_, n_b_).dot(Numbers<NB>(b_, n_b_));
    return sum;
  }

  [[gnu::always_inline]] void apply_normal(double dn) const {
    const double* const y = responses_;
    if constexpr (NA != 0) Velocities<NA>(a_, n_a_) += dn * Numbers<NA>(y, n_a_);
    if constexpr (NB != 0) Velocities<NB>(b_, n_b_) += dn * Numbers<NB>(y + n_a_, n_b_);
  }

  [[gnu::always_inline]] void apply(double dn, double d1, double d2) const {
    const Eigen::Index stride = n_a_ + n_b_;
    const double* const y0 = responses_;
    const double *const y1 = y0 + stride, *const y2 = y1 + stride;
    if constexpr (NA != 0)
      Velocities<NA>(a_, n_a_) += dn * Numbers<NA>(y0, n_a_) + d1 * Numbers<NA>(y1, n_a_) + d2 * Numbers<NA>(y2, n_a_);
    if constexpr (NB != 0)
      Velocities<NB>(b_, n_b_) +=
          dn * Numbers<NB>(y0 + n_a_, n_b_) + d1 * Numbers<NB>(y1 + n_a_, n_b_) + d2 * Numbers<NB>(y2 + n_a_, n_b_);
  }

 private:
  const double* rows_;
  const double* responses_;
  double* a_;
  double* b_;
  Eigen::Index n_a_, n_b_;
};

}  // namespace nilas::solvers
