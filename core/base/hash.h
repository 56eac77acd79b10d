#pragma once
/// 64-bit hash of state arrays, to compare runs bit for bit (FNV-1a over 64-bit words).
#include <bit>
#include <cstdint>

namespace nilas {

class StateHash {
 public:
  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x100000001b3ULL;
    value_ ^= value_ >> 32;
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  template <class Derived>
  void add_vector(const Derived& v) {
    for (int i = 0; i < static_cast<int>(v.size()); ++i) add(static_cast<double>(v[i]));
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace nilas
