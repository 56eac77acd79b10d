#pragma once
/// Which of two axes separates a pair better, with ties broken by geometry alone: a mirrored pair makes the mirrored
/// choice whatever the order in which its vertices and faces are listed.
#include <cmath>

#include "contact/detect/pair_view.h"

namespace nilas {

/// Relative difference below which two alignments count as equal.
constexpr double k_alignment_tie = 1e-9;

/// True when axis n with separation s beats `current`. Within the pair's tolerance of each other: the axis nearer to
/// the line of centres wins, then the one nearer to A's x axis, then to its y axis.
inline bool beats(const PairView& pair, const Vec3& n, double s, const Axis& current) {
  if (s > current.s + pair.tolerance) return true;
  if (s < current.s - pair.tolerance) return false;
  const Vec3 line = pair.b_in_a.point(pair.b.centre) - pair.a.centre;
  const double closer = n.dot(line) - current.n.dot(line);
  if (std::abs(closer) > k_alignment_tie * line.norm()) return closer > 0;
  for (int i : {0, 1}) {
    const double difference = std::abs(n[i]) - std::abs(current.n[i]);
    if (std::abs(difference) > k_alignment_tie) return difference > 0;
  }
  return n.x() > current.n.x() + k_alignment_tie;
}

}  // namespace nilas
