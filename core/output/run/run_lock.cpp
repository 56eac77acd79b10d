#include "core/output/run/run_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/base/error.h"

namespace nilas::output {

RunLock::RunLock(const std::filesystem::path& folder) {
  constexpr mode_t k_file_mode = 0666;  // reduced by the user's umask
  const std::filesystem::path log = folder / "nilas.log";
  // Opened for writing, because NFS gives exclusive locks on such descriptors only.
  descriptor_ = ::open(log.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, k_file_mode);
  if (descriptor_ < 0) throw FileError(log.string() + ": cannot write the log: " + std::strerror(errno));
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(descriptor_);
  throw FileError(folder.string() + ": another program is writing this run (it holds the lock on nilas.log)");
}

RunLock::~RunLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace nilas::output
