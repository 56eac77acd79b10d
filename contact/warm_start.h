#pragma once
/// Last step's impulses, found again by contact key. They are stored in G, because the tangents of a contact may turn
/// from step to step: t1 follows the body axis that is least parallel to the normal.
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/problem/problem.h"
#include "core/base/state.h"

namespace nilas::contact {

class WarmStart {
 public:
  /// Returns 3 nc impulses: those of the last step for keys that persist, zero for new contacts. `frames` are those of
  /// the present contacts, with orthonormal columns n, t1, t2 in G.
  VecX guess(const std::vector<std::uint64_t>& keys, const std::vector<Mat3>& frames) const;
  void keep(const std::vector<std::uint64_t>& keys, const std::vector<Mat3>& frames, const VecX& r);

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  std::vector<std::pair<std::uint64_t, Vec3>> sorted_;
};

}  // namespace nilas::contact
