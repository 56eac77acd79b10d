#pragma once
/// Files that stay complete while they grow: however the run ends, a reader finds whole rows only.
#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace nilas::output {

/// What the pieces of a file are: whole lines, so that what follows no line end is no piece, or bytes of any kind.
enum class Pieces { lines, bytes };

/// A file that grows by complete pieces. Each piece reaches the operating system in one write, so it outlives a
/// killed process. An optional tail (closing tags) follows the newest piece and is overwritten by the next one.
class OutputFile {
 public:
  /// Creates the file or empties it. `keep`: keeps that many bytes of an existing file, which must be complete pieces,
  /// and continues after them. Throws FileError; throws InputError and leaves the file unchanged where it is shorter,
  /// or where lines do not end there.
  explicit OutputFile(std::filesystem::path path, std::string tail = "", std::optional<std::int64_t> keep = {},
                      Pieces pieces = Pieces::lines);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Appends a piece. When it does not fit (full disk) the file is cut back to its last complete piece. Throws
  /// FileError.
  void append(std::string_view piece);
  /// Number of bytes of complete pieces.
  std::int64_t bytes() const { return body_end_; }
  const std::filesystem::path& path() const { return path_; }
  /// Reads `to.size()` bytes of complete pieces from `offset` on. Throws FileError, also where the file was cut since.
  void read(std::int64_t offset, std::span<std::byte> to) const;
  /// Returns when all pieces are on the disk. Throws FileError.
  void sync() const;
  /// Closes the file; some file systems report a full disk only here. Throws FileError.
  void close();

 private:
  bool write_at(off_t offset, std::string_view text);
  void cut_back();
  void cut_to(std::int64_t bytes);
  [[noreturn]] void fail(int error_number) const;

  std::filesystem::path path_;
  std::string tail_;
  Pieces pieces_;
  std::string buffer_;  ///< piece and tail
  int descriptor_ = -1;
  off_t body_end_ = 0;  ///< bytes of complete pieces
};

/// When a file reaches the disk: as the operating system pleases, or before the call returns.
enum class Flush { later, now };

/// Writes a whole file to a temporary file in the same folder and renames it: readers see the old or the new text. With
/// Flush::now that also holds after a loss of power. Throws FileError.
void write_whole(const std::filesystem::path& path, std::string_view text, Flush flush = Flush::later);

}  // namespace nilas::output
