#include "core/output/vtk/vtp_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "core/base/error.h"
#include "core/output/file/base64.h"

namespace nilas::output {

namespace {

static_assert(std::endian::native == std::endian::little, "the files declare byte_order LittleEndian");

// LZ4 block format: https://github.com/lz4/lz4/blob/dev/doc/lz4_Block_format.md
constexpr std::size_t k_smallest_match = 4;
constexpr std::size_t k_last_literals = 5;      // least number of literals at a block's end
constexpr std::size_t k_last_match_start = 12;  // least distance of the last match's start from the end
constexpr std::size_t k_nibble = 15, k_byte = 255;

/// Appends the part of a length that exceeds the four bits of a token.
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

/// The text of an array without values: number of blocks, plain size and size of the last partial block are 0.
std::string empty_array() {
  constexpr std::array<std::uint32_t, 3> k_header{};
  std::string text;
  add_base64(std::as_bytes(std::span(k_header)), text);
  return text;
}

/// Appends the text of an array: a header and, unless it is empty, one block.
void add_block(std::span<const std::byte> bytes, std::size_t width, std::string& text) {
  if (bytes.empty()) {
    text += empty_array();
    return;
  }
  const std::string block = compress_repeats(bytes, width);
  // One block: count, plain size, size of the last partial block, compressed size.
  const std::array<std::uint32_t, 4> header{1, static_cast<std::uint32_t>(bytes.size()), 0,
                                            static_cast<std::uint32_t>(block.size())};
  add_base64(std::as_bytes(std::span(header)), text);
  add_base64(std::as_bytes(std::span(block)), text);
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

std::string expand_block(std::string_view block, std::size_t size) {
  std::string out;
  out.reserve(size);
  std::size_t at = 0;
  const auto demand = [](bool holds) {
    if (!holds) throw InputError("is no LZ4 block of the size that it states");
  };
  const auto byte = [&] {
    demand(at < block.size());
    return static_cast<std::size_t>(static_cast<unsigned char>(block[at++]));
  };
  const auto length = [&](std::size_t nibble) {
    if (nibble < k_nibble) return nibble;
    for (std::size_t more = k_byte; more == k_byte;) nibble += more = byte();
    return nibble;
  };
  while (true) {
    const std::size_t token = byte(), literals = length(token >> 4);
    demand(literals <= block.size() - at && literals <= size - out.size());
    out.append(block.substr(at, literals));
    at += literals;
    if (at == block.size()) break;
    const std::size_t low = byte(), distance = low + (byte() << 8);
    const std::size_t match = length(token & k_nibble) + k_smallest_match;
    demand(distance > 0 && distance <= out.size() && match <= size - out.size());
    for (std::size_t k = 0; k < match; ++k) out += out[out.size() - distance];
  }
  demand(out.size() == size);
  return out;
}

void add_data_array(const ArrayType& type, std::span<const std::byte> bytes, std::size_t width, std::string& text) {
  const std::string count = type.of_field ? fmt::format(" NumberOfTuples=\"{}\"", bytes.size() / width) : std::string();
  text += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} format=\"binary\">", type.number,
                      type.name, type.components, count);
  add_block(bytes, width, text);
  text += "</DataArray>\n";
}

void add_text_array(const char* name, const std::vector<std::string>& texts, std::string& text) {
  std::string together;
  for (const auto& one : texts) together.append(one).push_back('\0');
  text +=
      fmt::format("<Array type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"binary\">", name, texts.size());
  add_block(std::as_bytes(std::span(together)), 1, text);
  text += "</Array>\n";
}

std::string array_bytes(std::string_view text) {
  if (text == empty_array()) return {};
  constexpr std::size_t k_header = 4 * sizeof(std::uint32_t), k_header_text = 4 * ((k_header + 2) / 3);
  if (text.size() < k_header_text) throw InputError("is no compressed array");
  const std::string header = from_base64(text.substr(0, k_header_text));
  std::array<std::uint32_t, 4> numbers{};
  std::memcpy(numbers.data(), header.data(), k_header);
  const std::string block = from_base64(text.substr(k_header_text));
  if (numbers[0] != 1 || numbers[2] != 0 || numbers[3] > block.size())
    throw InputError("is no array in one compressed block");
  return expand_block(std::string_view(block).substr(0, numbers[3]), numbers[1]);
}

void append(const Vec3& x, std::vector<float>& out) {
  for (const double component : x) out.push_back(static_cast<float>(component));
}

}  // namespace nilas::output
