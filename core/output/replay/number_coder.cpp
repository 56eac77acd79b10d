#include "core/output/replay/number_coder.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace nilas::output::replay {

namespace {

constexpr unsigned k_share_bits = 12, k_learning = 5, k_byte_bits = 8;
constexpr std::uint16_t k_one = 1u << k_share_bits, k_even = k_one / 2;
constexpr std::uint32_t k_least_range = 1u << 24, k_carry_from = 0xff000000;

}  // namespace

void NumberCoder::forget() {
  Shares even{};
  even.zero = even.negative = k_even;
  even.longer.fill(k_even);
  even.second.fill(k_even);
  for (auto& of_kind : shares_) of_kind.fill(even);
}

/// Writes the highest byte of `low_`. One of 255 waits, since a carry may come.
void NumberCoder::shift() {
  const auto carry = static_cast<std::uint8_t>(low_ >> 32);
  if (carry != 0 || static_cast<std::uint32_t>(low_) < k_carry_from) {
    for (std::uint8_t byte = held_; waiting_ > 0; --waiting_, byte = 0xff)
      bytes_.push_back(static_cast<char>(static_cast<std::uint8_t>(byte + carry)));
    held_ = static_cast<std::uint8_t>(low_ >> 24);
  }
  ++waiting_;
  low_ = (low_ & 0x00ffffff) << k_byte_bits;
}

void NumberCoder::narrow() {
  while (range_ < k_least_range) {
    range_ <<= k_byte_bits;
    shift();
  }
}

void NumberCoder::add_digit(bool one, Share& share) {
  const std::uint32_t bound = (range_ >> k_share_bits) * share;
  if (one) {
    low_ += bound;
    range_ -= bound;
    share = static_cast<Share>(share - (share >> k_learning));
  } else {
    range_ = bound;
    share = static_cast<Share>(share + ((k_one - share) >> k_learning));
  }
  narrow();
}

void NumberCoder::add_even_digit(bool one) {
  range_ >>= 1;
  if (one) low_ += range_;
  narrow();
}

std::uint8_t NumberCoder::add(std::size_t kind, std::uint8_t past, std::int64_t x) {
  Shares& shares = shares_[kind][past];
  const std::uint64_t size = x < 0 ? ~static_cast<std::uint64_t>(x) + 1 : static_cast<std::uint64_t>(x);
  const auto digits = static_cast<std::size_t>(std::bit_width(size));
  const auto own = static_cast<std::uint8_t>(std::min<std::size_t>(digits, k_most_digits));
  add_digit(size != 0, shares.zero);
  if (size == 0) return own;
  add_digit(x < 0, shares.negative);
  for (std::size_t k = 1; k <= digits; ++k) add_digit(k < digits, shares.longer[std::min(k, k_lengths) - 1]);
  if (digits < 2) return own;
  add_digit((size >> (digits - 2) & 1) != 0, shares.second[std::min(digits, k_lengths) - 1]);
  for (std::size_t k = digits - 2; k > 0; --k) add_even_digit((size >> (k - 1) & 1) != 0);
  return own;
}

std::string NumberCoder::finish() {
  constexpr int k_bytes_of_low = 5;
  for (int k = 0; k < k_bytes_of_low; ++k) shift();
  low_ = 0;
  range_ = k_whole_range;
  held_ = 0;
  waiting_ = 1;
  std::string bytes = std::exchange(bytes_, {});
  bytes.erase(0, 1);  // it is always 0
  return bytes;
}

}  // namespace nilas::output::replay
