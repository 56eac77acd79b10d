#pragma once
/// Pairs of parts that may touch: FCL's dynamic tree of boxes. Boxes are fattened so that the tree changes little from
/// step to step.
#include <memory>
#include <vector>

#include "contact/detect/broad/part.h"
#include "core/base/state.h"
#include "core/bodies/bodies.h"

namespace nilas {

/// Two bodies, and the places of two of their parts in the list of parts.
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

  /// All pairs of parts of different bodies, at least one of which can move, that may be nearer than `margin` [m]; no
  /// pair of planes. `parts` may only grow from call to call. In rising order by bodies, then by parts.
  /// `walk`: places of the pairs in the order in which the tree comes upon them. There neighbours in space follow each
  /// other, so that a part's geometry is still in the cache when its next pair asks for it.
  void list_pairs(const Bodies& bodies, const std::vector<Part>& parts, double margin, int threads,
                  std::vector<PartPair>& pairs, std::vector<int>& walk);

  /// The boxes, and the poses they were made for.
  void save(StateWriter out) const;
  /// Goes on with them, before the first call of list_pairs(). Throws InputError when they are not those of `parts`.
  void restore(const Bodies& bodies, const std::vector<Part>& parts, const StateReader& in);

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace nilas
