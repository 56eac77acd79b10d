#include "contact/warm_start.h"

#include <algorithm>
#include <bit>

#include "contact/problem/row_of.h"

namespace nilas::contact {

std::size_t WarmStart::slot_of(std::uint64_t key) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = key & mask;
  while (slots_[slot] != 0 && kept_[slots_[slot] - 1].key != key) slot = (slot + 1) & mask;
  return slot;
}

void WarmStart::index() {
  slots_.assign(std::bit_ceil(2 * kept_.size() + 1), 0);
  for (std::size_t i = 0; i < kept_.size(); ++i) slots_[slot_of(kept_[i].key)] = static_cast<std::uint32_t>(i + 1);
}

VecX WarmStart::guess(const std::vector<std::uint64_t>& keys, const std::vector<Mat3>& frames) const {
  VecX r = VecX::Zero(row_of(keys.size()));
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (const std::uint32_t found = slots_[slot_of(keys[i])]; found != 0)
      r.segment<3>(row_of(i)) = frames[i].transpose() * kept_[found - 1].impulse;
  return r;
}

void WarmStart::keep(const std::vector<std::uint64_t>& keys, const std::vector<Mat3>& frames, const VecX& r) {
  kept_.clear();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Vec3 impulse = r.segment<3>(row_of(i));
    if (!impulse.isZero(0)) kept_.push_back({keys[i], frames[i] * impulse});
  }
  index();
}

void WarmStart::save(StateWriter out) const {
  std::vector<Kept> sorted = kept_;
  std::sort(sorted.begin(), sorted.end(), [](const Kept& a, const Kept& b) { return a.key < b.key; });
  std::vector<std::uint64_t> keys;
  std::vector<Vec3> impulses;
  for (const Kept& kept : sorted) {
    keys.push_back(kept.key);
    impulses.push_back(kept.impulse);
  }
  out.add("key", keys);
  out.add("impulse", impulses);
}

void WarmStart::restore(const StateReader& in) {
  std::vector<std::uint64_t> keys;
  std::vector<Vec3> impulses;
  in.get("key", keys);
  in.get("impulse", impulses, keys.size());
  kept_.clear();
  for (std::size_t i = 0; i < keys.size(); ++i) kept_.push_back({keys[i], impulses[i]});
  index();
}

}  // namespace nilas::contact
