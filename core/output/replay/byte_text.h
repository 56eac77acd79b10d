#pragma once
/// Numbers as bytes of the replay file, little-endian: docs/reference/replay-file.md.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

namespace nilas::output::replay {

static_assert(std::endian::native == std::endian::little, "the replay file is written as numbers lie in memory");

template <class Number>
void add_number(Number x, std::string& out) {
  char bytes[sizeof(Number)];
  std::memcpy(bytes, &x, sizeof(Number));
  out.append(bytes, sizeof(Number));
}
inline void add_byte(int x, std::string& out) { out.push_back(static_cast<char>(static_cast<unsigned char>(x))); }
inline void add_float(double x, std::string& out) { add_number(static_cast<float>(x), out); }

inline void add_varint(std::uint64_t x, std::string& out) {
  constexpr std::uint64_t k_more = 0x80;
  while (x >= k_more) {
    out.push_back(static_cast<char>(static_cast<unsigned char>(x | k_more)));
    x >>= 7;
  }
  out.push_back(static_cast<char>(static_cast<unsigned char>(x)));
}
/// Small numbers of either sign take one byte.
inline void add_signed(std::int64_t x, std::string& out) {
  add_varint((static_cast<std::uint64_t>(x) << 1) ^ static_cast<std::uint64_t>(x >> 63), out);
}
inline void add_text(std::string_view text, std::string& out) {
  add_varint(text.size(), out);
  out.append(text);
}

/// x in units of `quantum`; numbers beyond 2^52 are cut there, so that readers keep them exact.
inline std::int64_t in_units(double x, double quantum) {
  constexpr double k_limit = 4503599627370496.0;
  const double units = std::round(x / quantum);
  return std::isfinite(units) ? static_cast<std::int64_t>(std::fmin(std::fmax(units, -k_limit), k_limit)) : 0;
}

}  // namespace nilas::output::replay
