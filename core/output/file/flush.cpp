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

}  // namespace

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

void flush_names(const fs::path& folder) { flush_one(folder); }

void UnflushedFiles::flush() {
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
