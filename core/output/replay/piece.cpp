#include "core/output/replay/piece.h"

#include <zlib.h>

#include <array>

#include "core/base/error.h"
#include "core/output/replay/byte_text.h"

namespace nilas::output::replay {

namespace {

constexpr std::size_t k_piece_head = 5;  // kind and length
// Fast packing: the numbers are small already, and the run waits for it.
constexpr int k_level = 1;

}  // namespace

std::string packed_piece(char kind, std::string_view content) {
  uLongf size = compressBound(static_cast<uLong>(content.size()));
  std::string piece(k_piece_head + size, '\0');
  const auto* from = reinterpret_cast<const Bytef*>(content.data());
  auto* to = reinterpret_cast<Bytef*>(piece.data() + k_piece_head);
  NILAS_DEMAND(compress2(to, &size, from, static_cast<uLong>(content.size()), k_level) == Z_OK);
  piece[0] = kind;
  const auto length = static_cast<std::uint32_t>(size);
  std::memcpy(piece.data() + 1, &length, sizeof length);
  piece.resize(k_piece_head + size);
  piece.push_back('\n');
  return piece;
}

std::string unpacked(std::string_view packed) {
  z_stream stream{};
  NILAS_DEMAND(inflateInit(&stream) == Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string content;
  std::array<char, 1 << 16> part;
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    state = inflate(&stream, Z_NO_FLUSH);
    content.append(part.data(), part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END) throw InputError("a piece of a replay file is damaged");
  return content;
}

PieceList pieces_of(std::string_view bytes, const std::string& source) {
  if (bytes.substr(0, k_signature.size()) != k_signature) {
    const bool other = bytes.substr(0, k_signature.size() - 1) == k_signature.substr(0, k_signature.size() - 1);
    throw InputError(source + (other ? ": was written by another version of the program; run the scene again"
                                     : ": is no replay file"));
  }
  PieceList list;
  std::size_t at = k_signature.size();
  while (at < bytes.size()) {
    std::uint32_t length = 0;
    if (bytes.size() - at >= k_piece_head) std::memcpy(&length, bytes.data() + at + 1, sizeof length);
    if (bytes.size() - at < k_piece_head + length + 1) break;
    const std::string_view whole = bytes.substr(at, k_piece_head + length + 1);
    if (whole.back() != '\n')
      throw InputError(source + ": is damaged at byte " + std::to_string(at) + ", where a piece should begin");
    list.pieces.push_back({whole.front(), whole, whole.substr(k_piece_head, length)});
    at += whole.size();
  }
  list.cut = bytes.size() - at;
  return list;
}

}  // namespace nilas::output::replay
