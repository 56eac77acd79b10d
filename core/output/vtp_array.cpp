#include "core/output/vtp_array.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "core/base/error.h"

namespace nilas {

namespace {

static_assert(std::endian::native == std::endian::little, "the files declare byte_order LittleEndian");

// LZ4 block format: https://github.com/lz4/lz4/blob/dev/doc/lz4_Block_format.md
constexpr std::size_t k_smallest_match = 4;
constexpr std::size_t k_last_literals = 5;      // a block ends with so many literals at least
constexpr std::size_t k_last_match_start = 12;  // the last match starts so far before the end at least
constexpr std::size_t k_nibble = 15, k_byte = 255;

/// What a token's four bits cannot hold of a length.
void add_length(std::size_t length, std::string& block) {
  if (length < k_nibble) return;
  length -= k_nibble;
  for (; length >= k_byte; length -= k_byte) block += static_cast<char>(k_byte);
  block += static_cast<char>(length);
}

void add_token(std::size_t literals, std::size_t match, std::string& block) {
  block += static_cast<char>((std::min(literals, k_nibble) << 4) | std::min(match, k_nibble));
  add_length(literals, block);
}

void add_base64(const void* data, std::size_t size, std::string& text) {
  const std::size_t before = text.size(), length = 4 * ((size + 2) / 3);
  text.resize(before + length + 1);  // OpenSSL ends with a zero
  auto* out = reinterpret_cast<unsigned char*>(text.data() + before);
  EVP_EncodeBlock(out, static_cast<const unsigned char*>(data), static_cast<int>(size));
  text.pop_back();
}

}  // namespace

std::string compress_repeats(std::span<const std::byte> bytes, std::size_t width) {
  NILAS_DEMAND(width > 0);
  const auto* data = reinterpret_cast<const char*>(bytes.data());
  const std::size_t size = bytes.size();
  std::string block;
  block.reserve(size + size / k_byte + k_last_match_start);
  std::size_t literal_start = 0;
  for (std::size_t i = width; i + k_last_match_start <= size;) {
    std::size_t end = i;
    while (end + width + k_last_literals <= size && std::memcmp(data + end, data + end - width, width) == 0)
      end += width;
    if (end - i < k_smallest_match) {
      i = end + width;
      continue;
    }
    const std::size_t literals = i - literal_start, match = end - i - k_smallest_match;
    add_token(literals, match, block);
    block.append(data + literal_start, literals);
    block += static_cast<char>(width);  // distance back, 16 bits, low byte first
    block += '\0';
    add_length(match, block);
    literal_start = end;
    i = end + width;
  }
  add_token(size - literal_start, 0, block);
  return block.append(data + literal_start, size - literal_start);
}

void add_data_array(const ArrayType& type, std::span<const std::byte> bytes, std::size_t width, std::string& text) {
  const std::string block = compress_repeats(bytes, width);
  // one block: its count, plain size, size of a last partial block, compressed size
  const std::array<std::uint32_t, 4> header{1, static_cast<std::uint32_t>(bytes.size()), 0,
                                            static_cast<std::uint32_t>(block.size())};
  text += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">", type.number,
                      type.name, type.components);
  add_base64(header.data(), sizeof(header), text);
  add_base64(block.data(), block.size(), text);
  text += "</DataArray>\n";
}

}  // namespace nilas
