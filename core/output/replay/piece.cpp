#include "core/output/replay/piece.h"

#include <zlib.h>

#include <array>
#include <utility>

#include "core/base/error.h"
#include "core/output/replay/byte_text.h"

namespace nilas::output::replay {

namespace {

constexpr std::size_t k_piece_head = 5;  // kind and length
/// Far more than a frame or the shapes of a million floes take.
constexpr std::size_t k_most_content = std::size_t{256} << 20;
// Fast packing: the numbers are small already, and the run waits for it.
constexpr int k_level = 1;

}  // namespace

std::string packed_piece(char kind, const Content& content) {
  z_stream stream{};
  NILAS_DEMAND(deflateInit(&stream, k_level) == Z_OK);
  constexpr std::size_t k_end_of_part = 8;  // room for what ends a part and begins the next
  std::string piece(k_piece_head + deflateBound(&stream, static_cast<uLong>(content.bytes.size())) +
                        k_end_of_part * content.parts.size(),
                    '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.bytes.data()));
  stream.next_out = reinterpret_cast<Bytef*>(piece.data() + k_piece_head);
  stream.avail_out = static_cast<uInt>(piece.size() - k_piece_head);
  std::size_t begin = 0;
  for (const Content::Part& part : content.parts) {
    stream.avail_in = static_cast<uInt>(part.begin - std::exchange(begin, part.begin));
    if (stream.avail_in > 0) NILAS_DEMAND(deflate(&stream, Z_BLOCK) == Z_OK && stream.avail_in == 0);
    NILAS_DEMAND(
        deflateParams(&stream, k_level, part.packing == Packing::dense ? Z_HUFFMAN_ONLY : Z_DEFAULT_STRATEGY) == Z_OK);
  }
  stream.avail_in = static_cast<uInt>(content.bytes.size() - begin);
  const int state = deflate(&stream, Z_FINISH);
  const auto length = static_cast<std::uint32_t>(stream.total_out);
  deflateEnd(&stream);
  NILAS_DEMAND(state == Z_STREAM_END);
  piece[0] = kind;
  std::memcpy(piece.data() + 1, &length, sizeof length);
  piece.resize(k_piece_head + length);
  piece.push_back('\n');
  return piece;
}

std::string packed_piece(char kind, std::string content) { return packed_piece(kind, Content{std::move(content), {}}); }

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
    if (content.size() > k_most_content) break;
  }
  inflateEnd(&stream);
  if (content.size() > k_most_content) throw InputError("a piece of a replay file unpacks to more than 256 MB");
  if (state != Z_STREAM_END) throw InputError("a piece of a replay file is damaged");
  return content;
}

PieceList pieces_of(std::string_view bytes, const std::string& source) {
  if (bytes.substr(0, k_signature.size()) != k_signature) {
    const std::size_t name = k_signature.size() - 1;
    if (bytes.substr(0, name) != k_signature.substr(0, name)) throw InputError(source + ": is no replay file");
    if (bytes.size() == name) throw InputError(source + ": ends before its first piece");
    throw InputError(source + ": has version " + bytes[name] + " of the replay, and this program reads version " +
                     k_signature[name] + "; run the scene again, or use the program that wrote it");
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
