#pragma once
/// Four contacts side by side: their numbers, and the velocities of their blocks.
#include "contact/solvers/linear/wide_clones.h"
#include "contact/solvers/shared/pgs_rows.h"

namespace nilas::solvers {

/// One number of each of four contacts.
using FourLanes = double __attribute__((vector_size(32), aligned(32)));
constexpr int k_lanes = sizeof(FourLanes) / sizeof(double);

/// Whether a contact can be visited with three others: its rows serve as responses, and both its blocks have six
/// numbers.
inline bool fits_lanes(const PgsContact& contact) {
  return contact.shape == PgsShape::six_six && contact.rows == contact.responses;
}

using FourNear = double __attribute__((vector_size(32), aligned(8), may_alias));
using TwoNear = double __attribute__((vector_size(16), aligned(8), may_alias));

/// The velocities of one block per lane, lane by lane.
NILAS_PART_OF_CLONES void gather_lanes(const double* velocities, const int (&first)[k_lanes], FourLanes (&x)[6]) {
  const FourLanes p0 = *reinterpret_cast<const FourNear*>(velocities + first[0]);
  const FourLanes p1 = *reinterpret_cast<const FourNear*>(velocities + first[1]);
  const FourLanes p2 = *reinterpret_cast<const FourNear*>(velocities + first[2]);
  const FourLanes p3 = *reinterpret_cast<const FourNear*>(velocities + first[3]);
  const FourLanes even01 = __builtin_shufflevector(p0, p1, 0, 4, 2, 6);
  const FourLanes odd01 = __builtin_shufflevector(p0, p1, 1, 5, 3, 7);
  const FourLanes even23 = __builtin_shufflevector(p2, p3, 0, 4, 2, 6);
  const FourLanes odd23 = __builtin_shufflevector(p2, p3, 1, 5, 3, 7);
  x[0] = __builtin_shufflevector(even01, even23, 0, 1, 4, 5);
  x[1] = __builtin_shufflevector(odd01, odd23, 0, 1, 4, 5);
  x[2] = __builtin_shufflevector(even01, even23, 2, 3, 6, 7);
  x[3] = __builtin_shufflevector(odd01, odd23, 2, 3, 6, 7);
  const TwoNear q0 = *reinterpret_cast<const TwoNear*>(velocities + first[0] + 4);
  const TwoNear q1 = *reinterpret_cast<const TwoNear*>(velocities + first[1] + 4);
  const TwoNear q2 = *reinterpret_cast<const TwoNear*>(velocities + first[2] + 4);
  const TwoNear q3 = *reinterpret_cast<const TwoNear*>(velocities + first[3] + 4);
  const FourLanes q02 = __builtin_shufflevector(q0, q2, 0, 1, 2, 3);
  const FourLanes q13 = __builtin_shufflevector(q1, q3, 0, 1, 2, 3);
  x[4] = __builtin_shufflevector(q02, q13, 0, 4, 2, 6);
  x[5] = __builtin_shufflevector(q02, q13, 1, 5, 3, 7);
}

NILAS_PART_OF_CLONES void scatter_lanes(const FourLanes (&x)[6], const int (&first)[k_lanes], int count,
                                        double* velocities) {
  const FourLanes low01 = __builtin_shufflevector(x[0], x[1], 0, 4, 2, 6);
  const FourLanes low23 = __builtin_shufflevector(x[2], x[3], 0, 4, 2, 6);
  const FourLanes high01 = __builtin_shufflevector(x[0], x[1], 1, 5, 3, 7);
  const FourLanes high23 = __builtin_shufflevector(x[2], x[3], 1, 5, 3, 7);
  const FourLanes q02 = __builtin_shufflevector(x[4], x[5], 0, 4, 2, 6);
  const FourLanes q13 = __builtin_shufflevector(x[4], x[5], 1, 5, 3, 7);
  const auto four = [ velocities, &first ](int lane) __attribute__((always_inline)) {
    return reinterpret_cast<FourNear*>(velocities + first[lane]);
  };
  const auto two = [ velocities, &first ](int lane) __attribute__((always_inline)) {
    return reinterpret_cast<TwoNear*>(velocities + first[lane] + 4);
  };
  *four(0) = __builtin_shufflevector(low01, low23, 0, 1, 4, 5);
  *two(0) = __builtin_shufflevector(q02, q02, 0, 1);
  if (count > 1) {
    *four(1) = __builtin_shufflevector(high01, high23, 0, 1, 4, 5);
    *two(1) = __builtin_shufflevector(q13, q13, 0, 1);
  }
  if (count > 2) {
    *four(2) = __builtin_shufflevector(low01, low23, 2, 3, 6, 7);
    *two(2) = __builtin_shufflevector(q02, q02, 2, 3);
  }
  if (count > 3) {
    *four(3) = __builtin_shufflevector(high01, high23, 2, 3, 6, 7);
    *two(3) = __builtin_shufflevector(q13, q13, 2, 3);
  }
}

/// J_A v_A + J_B v_B of one row. Sides::velocity adds in the same order.
NILAS_PART_OF_CLONES void row_velocity(const FourLanes (&row)[12], const FourLanes (&a)[6], const FourLanes (&b)[6],
                                       FourLanes& u) {
  FourLanes product[6];
  for (int k = 0; k < 6; ++k) product[k] = row[k] * a[k] + row[6 + k] * b[k];
  u = (product[0] + (product[2] + product[4])) + (product[1] + (product[3] + product[5]));
}

}  // namespace nilas::solvers
