#pragma once
/// A lock that keeps two programs from writing into one run folder.
#include <filesystem>
#include <utility>

namespace nilas::output {

/// An advisory lock (flock) on a folder's nilas.log, which is created if missing. The system releases it when the
/// program ends in any way. It has no effect on file systems without locks.
class RunLock {
 public:
  /// Throws FileError when another program holds the lock, or when the log cannot be opened.
  explicit RunLock(const std::filesystem::path& folder);
  ~RunLock();
  RunLock(RunLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  RunLock& operator=(RunLock&&) = delete;
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

 private:
  int descriptor_ = -1;
};

}  // namespace nilas::output
