#pragma once
/// Cholesky factor of a 3 x 3 matrix, in closed form.
#include <cmath>

#include "core/base/math.h"

namespace nilas::contact {

/// L^-1 of m = L L^T, lower triangular. Reads the lower triangle; not finite where m is not positive definite.
inline Mat3 inverse_root(const Mat3& m) {
  const double l00 = std::sqrt(m(0, 0)), l10 = m(1, 0) / l00, l20 = m(2, 0) / l00;
  const double l11 = std::sqrt(m(1, 1) - l10 * l10), l21 = (m(2, 1) - l20 * l10) / l11;
  const double l22 = std::sqrt(m(2, 2) - l20 * l20 - l21 * l21);
  Mat3 root = Mat3::Zero();
  root(0, 0) = 1 / l00;
  root(1, 1) = 1 / l11;
  root(2, 2) = 1 / l22;
  root(1, 0) = -l10 * root(0, 0) / l11;
  root(2, 1) = -l21 * root(1, 1) / l22;
  root(2, 0) = -(l20 * root(0, 0) + l21 * root(1, 0)) / l22;
  return root;
}

}  // namespace nilas::contact
