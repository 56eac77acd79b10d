#pragma once
/// Numbers of a replay frame as bits of adaptive length: an arithmetic coder. docs/reference/replay-file.md describes
/// it.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace nilas::output::replay {

/// What a number tells. Each has probabilities of its own. Of the ranges the first is named.
enum NumberKind : std::size_t {
  k_of_position = 0,
  k_of_turn = 3,
  k_of_speed = 7,
  k_of_island = 8,
  k_of_damage = 9,
  k_of_parting = 10,
  k_of_new_pairs = 11,
  k_of_first = 12,
  k_of_second = 13,
  k_of_status = 14,
  k_of_pair = 15,
  k_number_kinds = 23
};

/// How many binary digits the number before had, of the same kind and of the same body or pair: 5 stands for more.
constexpr std::uint8_t k_most_digits = 5;
/// There was no number before.
constexpr std::uint8_t k_no_past = 6;

class NumberCoder {
 public:
  NumberCoder() { forget(); }
  /// All probabilities are even again.
  void forget();
  /// Adds a number of a kind after one of `past` digits. Returns its own digits, at most k_most_digits.
  std::uint8_t add(std::size_t kind, std::uint8_t past, std::int64_t x);
  /// The bytes of all numbers since the last call.
  std::string finish();

 private:
  static constexpr std::uint32_t k_whole_range = 0xffffffff;
  static constexpr std::size_t k_lengths = 20, k_pasts = k_no_past + 1;
  /// How likely a binary digit is 0, in units of 2^-12.
  using Share = std::uint16_t;
  struct Shares {
    Share zero, negative;
    std::array<Share, k_lengths> longer;  ///< by the digits so far
    std::array<Share, k_lengths> second;  ///< second highest digit, by the number of digits
  };

  void add_digit(bool one, Share& share);
  void add_even_digit(bool one);
  void narrow();
  void shift();

  std::array<std::array<Shares, k_pasts>, k_number_kinds> shares_;
  std::uint64_t low_ = 0;
  std::uint32_t range_ = k_whole_range;
  std::uint8_t held_ = 0;    ///< the first byte that waits; those after it are 255
  std::size_t waiting_ = 1;  ///< number of bytes that a carry may change
  std::string bytes_;
};

}  // namespace nilas::output::replay
