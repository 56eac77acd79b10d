#include "apps/view/block_text.h"

#include <array>
#include <cstdint>

namespace nilas::view {

namespace {

constexpr unsigned k_letters = 91, k_bits = 13, k_bits_of_one = 6;
static_assert(k_letters * k_letters >= 1U << k_bits && k_letters >= 1U << k_bits_of_one);

constexpr std::array<char, k_letters> make_letters() {
  std::array<char, k_letters> letters{};
  std::size_t count = 0;
  for (char c = '!'; c <= '~'; ++c)
    if (c != '"' && c != '&' && c != '<') letters[count++] = c;
  return letters;
}
constexpr std::array<char, k_letters> k_alphabet = make_letters();
static_assert(k_alphabet.back() == '~');

}  // namespace

void add_block_text(std::string_view bytes, std::string& text) {
  constexpr std::uint32_t k_mask = (1U << k_bits) - 1;
  constexpr unsigned k_byte = 8;
  text.reserve(text.size() + 2 * (bytes.size() * k_byte / k_bits + 1));
  std::uint32_t waiting = 0;
  unsigned count = 0;
  for (const char c : bytes) {
    waiting |= static_cast<std::uint32_t>(static_cast<unsigned char>(c)) << count;
    count += k_byte;
    if (count < k_bits) continue;
    text.push_back(k_alphabet[(waiting & k_mask) % k_letters]);
    text.push_back(k_alphabet[(waiting & k_mask) / k_letters]);
    waiting >>= k_bits;
    count -= k_bits;
  }
  if (count == 0) return;
  text.push_back(k_alphabet[waiting % k_letters]);
  if (count > k_bits_of_one) text.push_back(k_alphabet[waiting / k_letters]);
}

}  // namespace nilas::view
