#include "contact/warm_start.h"

#include <algorithm>

#include "contact/problem/row_of.h"

namespace nilas::contact {

VecX WarmStart::guess(const std::vector<std::uint64_t>& keys, const std::vector<Mat3>& frames) const {
  VecX r = VecX::Zero(row_of(keys.size()));
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), keys[i],
                                        [](const auto& entry, std::uint64_t key) { return entry.first < key; });
    if (found != sorted_.end() && found->first == keys[i])
      r.segment<3>(row_of(i)) = frames[i].transpose() * found->second;
  }
  return r;
}

void WarmStart::keep(const std::vector<std::uint64_t>& keys, const std::vector<Mat3>& frames, const VecX& r) {
  sorted_.clear();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Vec3 impulse = r.segment<3>(row_of(i));
    if (!impulse.isZero(0)) sorted_.emplace_back(keys[i], frames[i] * impulse);
  }
  std::sort(sorted_.begin(), sorted_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

void WarmStart::save(StateWriter out) const {
  std::vector<std::uint64_t> keys;
  std::vector<Vec3> impulses;
  for (const auto& [key, impulse] : sorted_) {
    keys.push_back(key);
    impulses.push_back(impulse);
  }
  out.add("key", keys);
  out.add("impulse", impulses);
}

void WarmStart::restore(const StateReader& in) {
  std::vector<std::uint64_t> keys;
  std::vector<Vec3> impulses;
  in.get("key", keys);
  in.get("impulse", impulses, keys.size());
  sorted_.clear();
  for (std::size_t i = 0; i < keys.size(); ++i) sorted_.emplace_back(keys[i], impulses[i]);
}

}  // namespace nilas::contact
