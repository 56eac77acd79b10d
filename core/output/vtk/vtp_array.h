#pragma once
/// Number arrays inside ParaView's XML files: LZ4 blocks as base64 text, so the file stays well-formed XML.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/math.h"

namespace nilas::output {

/// Compresses to an LZ4 block (format 1.6) that stores consecutive repeats of a value of `width` bytes as one match,
/// and everything else as literals: the thousands of facets of one body have the same velocity.
std::string compress_repeats(std::span<const std::byte> bytes, std::size_t width);
/// Expands an LZ4 block of `size` plain bytes. Throws InputError where it is no such block.
std::string expand_block(std::string_view block, std::size_t size);

/// Name, VTK's name of the number type, and numbers per value.
struct ArrayType {
  const char* name;
  const char* number;
  std::size_t components;
  bool of_field = false;  ///< true for field data, which state their number of values
};
/// Appends a <DataArray> element to `text`. `width`: bytes of one value with all its components.
void add_data_array(const ArrayType& type, std::span<const std::byte> bytes, std::size_t width, std::string& text);

/// Appends an <Array> of texts for a document's field data.
void add_text_array(const char* name, const std::vector<std::string>& texts, std::string& text);
/// The bytes of an array that add_data_array() wrote, from the text of its element. Throws InputError where it is none.
std::string array_bytes(std::string_view text);

template <class Number>
void add_data_array(const ArrayType& type, const std::vector<Number>& x, std::string& text) {
  add_data_array(type, std::as_bytes(std::span(x)), sizeof(Number) * type.components, text);
}

/// Appends the three components of x.
void append(const Vec3& x, std::vector<float>& out);

}  // namespace nilas::output
