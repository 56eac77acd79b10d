#pragma once
/// Bytes as letters of a page, denser than base64: 13 bits in two letters.
#include <string>
#include <string_view>

namespace nilas::view {

/// So many bytes, or a multiple of them, become whole pairs of letters.
inline constexpr std::size_t k_block_text_bytes = 13;

/// Appends bytes as letters. They are the 91 printable ones of ASCII without the space and those that HTML may take for
/// something else: " & <. The bits are taken from the lowest bit of the first byte on. 13 bits b are two letters, the
/// first of number b mod 91, the second of number b / 91. At the end up to 6 bits are one letter.
void add_block_text(std::string_view bytes, std::string& text);

}  // namespace nilas::view
