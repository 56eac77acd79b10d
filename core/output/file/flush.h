#pragma once
/// Waits until files are on the disk, so that a loss of power spares them.
#include <filesystem>
#include <set>

namespace nilas::output {

/// Returns when the names in a folder are on the disk. Some file systems refuse to flush folders, which is no fault.
/// Throws FileError.
void flush_names(const std::filesystem::path& folder);
/// The folder of a file; that of a bare name is the current one.
std::filesystem::path folder_of(const std::filesystem::path& file);

/// The files of a run that were written since its newest checkpoint, which must not be on the disk before them.
class UnflushedFiles {
 public:
  /// `wanted`: the run may write checkpoints, if only where it is stopped; nothing is noted without.
  explicit UnflushedFiles(bool wanted) : wanted_(wanted) {}
  /// Notes a whole file.
  void add(const std::filesystem::path& file) {
    if (wanted_) files_.insert(file);
  }
  /// Flushes all files that were noted and still have their names, and forgets them. Throws FileError.
  void flush();

 private:
  bool wanted_;
  std::set<std::filesystem::path> files_;
};

}  // namespace nilas::output
