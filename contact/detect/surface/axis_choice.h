#pragma once
/// Chooses the axis that separates a pair best, with ties broken by geometry alone. A mirrored pair makes the mirrored
/// choice, in whatever order its vertices and faces are listed.
#include <algorithm>
#include <limits>
#include <vector>

#include "contact/detect/broad/pair_view.h"

namespace nilas::detect {

/// Relative difference below which two alignments count as equal.
constexpr double k_alignment_tie = 1e-9;

/// Takes the axes of a search one by one. The choice waits for the last of them, because being within a tolerance of
/// each other is not transitive. A choice between two at a time would depend on their order.
class AxisContest {
 public:
  /// `room`: storage, reused from search to search.
  AxisContest(const PairView& pair, std::vector<Axis>& room) : pair_(pair), rivals_(room) { rivals_.clear(); }

  void enter(const Axis& axis) {
    if (!(axis.s >= highest_ - pair_.tolerance)) return;
    highest_ = std::max(highest_, axis.s);
    rivals_.push_back(axis);
  }

  /// The largest separation so far [m]; -infinity without any.
  double highest() const { return highest_; }

  /// Returns the choice among the axes within the pair's tolerance of the largest separation. It is the nearest to the
  /// line of centres, then the nearest to A's x axis, then to its y axis, then the one towards x, then towards z. Of
  /// axes that coincide, a face goes before edges. A default axis without any.
  Axis winner();

 private:
  const PairView& pair_;
  std::vector<Axis>& rivals_;
  double highest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace nilas::detect
