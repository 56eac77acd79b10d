#pragma once
/// Files that stay complete while they grow: whatever ends the run, a reader finds whole rows only.
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace nilas {

/// A text file that grows by complete pieces. Each piece reaches the operating system in one write, so it outlives a
/// killed process. An optional tail (closing tags) follows the newest piece and is overwritten by the next one.
class OutputFile {
 public:
  /// Creates the file or empties it. Throws FileError.
  explicit OutputFile(std::filesystem::path path, std::string tail = "");
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Appends a piece. When it does not fit (full disk) the file is cut back to its last complete piece. Throws
  /// FileError.
  void append(std::string_view piece);
  /// Closes the file; some file systems report a full disk only here. Throws FileError.
  void close();

 private:
  bool write_at(off_t offset, std::string_view text);
  void cut_back();
  [[noreturn]] void fail(int error_number) const;

  std::filesystem::path path_;
  std::string tail_;
  std::string buffer_;  ///< piece and tail
  int descriptor_ = -1;
  off_t body_end_ = 0;  ///< bytes of complete pieces
};

/// Writes a whole file through a temporary neighbour and a rename: readers see the old text or the new. Throws
/// FileError.
void write_whole(const std::filesystem::path& path, std::string_view text);

}  // namespace nilas
