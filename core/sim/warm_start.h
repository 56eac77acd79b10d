#pragma once
/// Last step's impulses, found again by contact key.
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/problem.h"
#include "core/base/state.h"

namespace nilas {

class WarmStart {
 public:
  /// 3 nc impulses: those of last step for keys that persist, zero for new contacts.
  VecX guess(const std::vector<std::uint64_t>& keys) const;
  void keep(const std::vector<std::uint64_t>& keys, const VecX& r);

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  std::vector<std::pair<std::uint64_t, Vec3>> sorted_;
};

}  // namespace nilas
