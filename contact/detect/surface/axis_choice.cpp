#include "contact/detect/surface/axis_choice.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace nilas::detect {

namespace {

/// Keeps the axes whose measure is within `tie` of the largest.
template <class Measure>
void keep_largest(std::vector<Axis>& rivals, double tie, const Measure& measure) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const Axis& axis : rivals) largest = std::max(largest, measure(axis));
  std::erase_if(rivals, [&](const Axis& axis) { return measure(axis) < largest - tie; });
}

}  // namespace

Axis AxisContest::winner() {
  if (rivals_.empty()) return {};
  keep_largest(rivals_, pair_.tolerance, [](const Axis& axis) { return axis.s; });
  if (rivals_.size() == 1) return rivals_.front();
  const Vec3 line = pair_.b_in_a.point(pair_.b.centre) - pair_.a.centre;
  keep_largest(rivals_, k_alignment_tie * line.norm(), [&](const Axis& axis) { return axis.n.dot(line); });
  for (const int i : {0, 1})
    keep_largest(rivals_, k_alignment_tie, [i](const Axis& axis) { return std::abs(axis.n[i]); });
  for (const int i : {0, 2}) keep_largest(rivals_, k_alignment_tie, [i](const Axis& axis) { return axis.n[i]; });
  // what is left coincides but for rounding, in numbers that a mirrored pair shares
  const auto rank = [&](const Axis& axis) {
    return std::tuple(-static_cast<int>(axis.kind), axis.s, axis.n.dot(line), axis.n.x(), std::abs(axis.n.y()),
                      axis.n.z());
  };
  return *std::max_element(rivals_.begin(), rivals_.end(),
                           [&](const Axis& a, const Axis& b) { return rank(a) < rank(b); });
}

}  // namespace nilas::detect
