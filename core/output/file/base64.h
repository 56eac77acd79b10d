#pragma once
/// Bytes as base64 text, for files that must be text.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace nilas::output {

/// Appends the bytes, at most 2^30 of them, with padding and without line breaks.
void add_base64(std::span<const std::byte> bytes, std::string& text);
/// Decodes whole groups of four characters, including the zeros that pad the last group. Throws InputError.
std::string from_base64(std::string_view text);

}  // namespace nilas::output
