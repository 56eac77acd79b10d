#pragma once
/// A folder of this program's own that is removed in the end.
#include <filesystem>

namespace nilas::view {

class ScratchFolder {
 public:
  /// Makes a new folder that no other user can read, in $TMPDIR or /tmp. Throws FileError.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace nilas::view
