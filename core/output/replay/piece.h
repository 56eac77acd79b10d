#pragma once
/// The pieces of a replay file: kind, length, packed content, line feed. docs/reference/replay-file.md describes them.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace nilas::output::replay {

/// The bytes with which a replay file starts; the last one is the version.
inline constexpr std::string_view k_signature = "NILASRP4";

inline constexpr char k_head = 'H', k_shape = 'S', k_frame = 'F', k_waves = 'W', k_end = 'E', k_live = 'L';

/// What a part of a content is like: `mixed`, where the same bytes come again, or `dense`, which cannot be packed
/// further.
enum class Packing { mixed, dense };

/// The content of a piece while it is put together. Each part is packed by itself; readers see no difference.
struct Content {
  struct Part {
    std::size_t begin = 0;
    Packing packing = Packing::mixed;
  };
  std::string bytes;
  std::vector<Part> parts;  ///< none: all is mixed

  /// What is added from now on is a part.
  void begin(Packing packing) { parts.push_back({bytes.size(), packing}); }
  void clear() {
    bytes.clear();
    parts.clear();
  }
};

/// The piece with this content, packed.
std::string packed_piece(char kind, const Content& content);
std::string packed_piece(char kind, std::string content);
/// The content of a packed piece. Throws InputError where it is damaged.
std::string unpacked(std::string_view packed);

/// A piece in the bytes of a file.
struct PieceView {
  char kind = 0;
  std::string_view bytes;   ///< the whole piece as it is stored
  std::string_view packed;  ///< its packed content
};
/// The whole pieces of a replay file in turn.
struct PieceList {
  std::vector<PieceView> pieces;
  std::size_t cut = 0;  ///< number of bytes of an incomplete piece at the end
};
/// `source` names the file in messages. Throws InputError where the bytes are not those of a replay file, or of one of
/// another version, or where a piece within the file is damaged.
PieceList pieces_of(std::string_view bytes, const std::string& source);

}  // namespace nilas::output::replay
