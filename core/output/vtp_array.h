#pragma once
/// Number arrays inside ParaView's XML files: LZ4 blocks as base64 text, so the file stays well-formed XML.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace nilas {

/// LZ4 block that stores repeats of a value of `width` bytes, coming one after another, as one match and all else as
/// literals: the thousands of facets of one body carry the same velocity. Format: LZ4 block format 1.6.
std::string compress_repeats(std::span<const std::byte> bytes, std::size_t width);

/// Name, VTK's name of the number type, numbers per value.
struct ArrayType {
  const char* name;
  const char* number;
  std::size_t components;
};
/// Appends a <DataArray> element to `text`. `width`: bytes of one value with all its components.
void add_data_array(const ArrayType& type, std::span<const std::byte> bytes, std::size_t width, std::string& text);

template <class Number>
void add_data_array(const ArrayType& type, const std::vector<Number>& x, std::string& text) {
  add_data_array(type, std::as_bytes(std::span(x)), sizeof(Number) * type.components, text);
}

}  // namespace nilas
