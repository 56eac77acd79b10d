#pragma once
/// Lists the pairs of parts that may touch, by FCL's dynamic tree of boxes. Boxes are fattened so that the tree changes
/// little from step to step.
#include <memory>
#include <vector>

#include "contact/detect/broad/part.h"
#include "core/base/state.h"
#include "core/bodies/bodies.h"

namespace nilas::detect {

/// Two bodies, and the indices of two of their parts in the list of parts.
struct PartPair {
  int body_a = 0, body_b = 0;
  int part_a = 0, part_b = 0;
  friend bool operator==(const PartPair&, const PartPair&) = default;
  friend auto operator<=>(const PartPair&, const PartPair&) = default;
};

class BroadPhase {
 public:
  BroadPhase();
  ~BroadPhase();
  BroadPhase(BroadPhase&&) noexcept;
  BroadPhase& operator=(BroadPhase&&) noexcept;

  /// Lists all pairs of parts of different bodies that may be nearer than `margin` [m] and of which at least one can
  /// move. Pairs of planes are left out. `parts` may only grow from call to call. The order rises by bodies, then by
  /// parts.
  void list_pairs(const bodies::Bodies& bodies, const std::vector<Part>& parts, double margin, int threads,
                  std::vector<PartPair>& pairs);

  /// Saves the boxes and the poses for which they were made.
  void save(StateWriter out) const;
  /// Restores saved boxes, before the first call of list_pairs(). Throws InputError when they are not those of `parts`.
  void restore(const bodies::Bodies& bodies, const std::vector<Part>& parts, const StateReader& in);

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace nilas::detect
