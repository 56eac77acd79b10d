#pragma once
/// Last step's impulses, found again by contact key. They are stored in G, because the tangents of a contact may turn
/// from step to step: t1 follows the body axis that is least parallel to the normal.
#include <cstddef>
#include <cstdint>
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
  struct Kept {
    std::uint64_t key = 0;
    Vec3 impulse = Vec3::Zero();
  };
  void index();
  /// The place in `slots_` of the entry with this key, else the free place where it belongs.
  std::size_t slot_of(std::uint64_t key) const;

  std::vector<Kept> kept_;
  /// Open addressing by the low bits of the keys, which are hashes. A slot holds 1 + an index of `kept_`, or 0. Their
  /// number is a power of two, and at least half of them stay free.
  std::vector<std::uint32_t> slots_{0};
};

}  // namespace nilas::contact
