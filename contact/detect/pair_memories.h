#pragma once
/// The memories of the pairs of parts from a detector's last call.
#include <vector>

#include "contact/detect/broad/broad_phase.h"
#include "contact/detect/narrow_phase.h"
#include "core/base/state.h"

namespace nilas::detect {

/// One memory per pair, in the order of the pairs (that of the broad phase).
struct PairMemories {
  std::vector<PartPair> pairs;
  std::vector<PairMemory> memory;

  /// Drops the pairs of parts that are gone; `new_part` is that of KnownParts::forget_gone.
  void forget_gone(const std::vector<int>& new_part, const std::vector<Part>& parts);
  void save(StateWriter out) const;
  /// Throws InputError when the state belongs to other parts.
  void restore(const std::vector<Part>& parts, const StateReader& in);
};

}  // namespace nilas::detect
