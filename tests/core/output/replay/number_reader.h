#pragma once
/// Reads the coded numbers of a replay frame by docs/reference/replay-file.md, written apart from the program.
#include <algorithm>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>

namespace nilas::test {

constexpr int k_no_number_before = 6;

/// How many binary digits a number has, 5 for more.
inline int digits_of(std::int64_t x) {
  int digits = 0;
  for (std::int64_t size = x < 0 ? -x : x; size > 0; size /= 2) ++digits;
  return std::min(digits, 5);
}

class NumberReader {
 public:
  /// How likely a digit is 0, by kind, digits before, what the digit says (0 zero, 1 sign, 2 longer, 3 second) and its
  /// place.
  using Shares = std::map<std::tuple<int, int, int, int>, std::uint32_t>;

  NumberReader(std::string bytes, Shares& shares) : bytes_(std::move(bytes)), shares_(shares) {
    for (int k = 0; k < 4; ++k) take_byte();
  }
  bool at_end() const { return at_ == bytes_.size(); }

  std::int64_t number(int kind, int before) {
    if (!digit({kind, before, 0, 0})) return 0;
    const bool negative = digit({kind, before, 1, 0});
    int digits = 1;
    while (digit({kind, before, 2, std::min(digits, 20)})) ++digits;
    std::int64_t size = 1;
    if (digits > 1) size = 2 + (digit({kind, before, 3, std::min(digits, 20)}) ? 1 : 0);
    for (int k = 2; k < digits; ++k) {
      range_ /= 2;
      size = 2 * size + (is_upper(range_) ? 1 : 0);
      narrow();
    }
    return negative ? -size : size;
  }

 private:
  void take_byte() { code_ = code_ << 8 | static_cast<unsigned char>(bytes_.at(at_++)); }
  void narrow() {
    for (; range_ < 1u << 24; range_ <<= 8) take_byte();
  }
  /// Whether the code is at or above a bound, which is then taken off.
  bool is_upper(std::uint32_t bound) {
    if (code_ < bound) return false;
    code_ -= bound;
    return true;
  }
  bool digit(const std::tuple<int, int, int, int>& place) {
    std::uint32_t& share = shares_.try_emplace(place, 2048u).first->second;
    const std::uint32_t bound = range_ / 4096 * share;
    const bool one = is_upper(bound);
    range_ = one ? range_ - bound : bound;
    share = one ? share - share / 32 : share + (4096 - share) / 32;
    narrow();
    return one;
  }

  std::string bytes_;
  Shares& shares_;
  std::size_t at_ = 0;
  std::uint32_t range_ = 0xffffffff, code_ = 0;
};

}  // namespace nilas::test
