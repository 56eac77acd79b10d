#include "core/output/file/flush.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/base/error.h"

namespace nilas::output {

namespace fs = std::filesystem;

namespace {

/// The number of the error, or 0.
int flush_one(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return errno;
  const int error_number = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  return error_number;
}

/// More files than these are flushed with all else of their disk: each flush of its own takes the disk a turn.
constexpr std::size_t k_most_one_by_one = 32;

/// Flushes the whole disk that holds a file. Returns false where the system does not say that this was done.
bool flush_disk_of(const fs::path& file) {
  const int descriptor = ::open(folder_of(file).c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool is_done = ::syncfs(descriptor) == 0;
  ::close(descriptor);
  return is_done;
}

}  // namespace

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

void flush_names(const fs::path& folder) {
  const int error_number = flush_one(folder);
  const bool is_refused = error_number == EINVAL || error_number == ENOTSUP || error_number == EBADF ||
                          error_number == EACCES || error_number == EROFS;
  if (error_number != 0 && !is_refused)
    throw FileError(folder.string() + ": cannot write: " + std::strerror(error_number));
}

void UnflushedFiles::flush() {
  if (files_.size() > k_most_one_by_one && flush_disk_of(*files_.begin())) {
    files_.clear();
    return;
  }
  std::set<fs::path> folders;
  for (const auto& file : files_) {
    const int error_number = flush_one(file);
    if (error_number == ENOENT) continue;  // it has been replaced or renamed since
    if (error_number != 0) throw FileError(file.string() + ": cannot write: " + std::strerror(error_number));
    folders.insert(folder_of(file));
  }
  for (const auto& folder : folders) flush_names(folder);
  files_.clear();
}

}  // namespace nilas::output
