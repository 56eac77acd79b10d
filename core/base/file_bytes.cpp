#include "core/base/file_bytes.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <new>
#include <span>
#include <vector>

namespace nilas {

namespace fs = std::filesystem;

/// Returns the names in a folder in order; none where it cannot be read.
static std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    names.push_back(entry->path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

FileError nothing_there(const fs::path& path, const std::string& kind) {
  const fs::path written = path.has_filename() ? path : path.parent_path();
  const fs::path folder = written.has_parent_path() ? written.parent_path() : fs::path(".");
  const std::string name = nearest_name(written.filename().string(), names_in(folder));
  const std::string near = name.empty() ? "" : (written.parent_path() / name).string();
  return FileError(path.string() + ": there is no such " + kind + (near.empty() ? "" : "; nearest: " + near));
}

void demand_there(const fs::path& path, const std::string& kind) {
  std::error_code ignored;
  if (fs::status(path, ignored).type() == fs::file_type::not_found) throw nothing_there(path, kind);
}

namespace {

/// An open file, closed at the end of its life.
class OpenFile {
 public:
  /// Without waiting for a program at the other end of a pipe.
  explicit OpenFile(const fs::path& path) : descriptor_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int descriptor() const { return descriptor_; }
  struct stat status() const {
    struct stat found {};
    if (descriptor_ >= 0) ::fstat(descriptor_, &found);
    return found;
  }

 private:
  int descriptor_;
};

void demand_readable(const OpenFile& open, const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) throw FileError(file.string() + ": is a folder, and a file is needed");
  if (open.descriptor() < 0) throw FileError(file.string() + ": cannot be opened");
  const mode_t mode = open.status().st_mode;
  if (!S_ISREG(mode) && !S_ISFIFO(mode)) throw FileError(file.string() + ": is a device, and a file is needed");
}

/// Waits until a pipe has bytes, or until the program that wrote into it is done. A pipe that no program has opened yet
/// reads as empty, but poll waits for one.
void await_bytes(const OpenFile& open, const fs::path& file) {
  constexpr int k_wait = 10000;  // [ms]
  pollfd one{open.descriptor(), POLLIN, 0};
  if (::poll(&one, 1, k_wait) == 0) throw FileError(file.string() + ": is a pipe from which nothing came for 10 s");
}

/// The next bytes; none at the end.
std::size_t read_block(const OpenFile& open, const fs::path& file, std::span<char> block) {
  while (true) {
    await_bytes(open, file);
    const ssize_t count = ::read(open.descriptor(), block.data(), block.size());
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR && errno != EAGAIN) throw FileError(file.string() + ": cannot be read");
  }
}

}  // namespace

std::string file_bytes(const fs::path& file, std::size_t most) {
  demand_there(file, "file");
  const OpenFile open(file);
  demand_readable(open, file);
  const auto demand_few = [&](std::size_t bytes) {
    if (bytes > most)
      throw InputError(file.string() + ": is too large; allowed: " + std::to_string(most >> 20) + " MB");
  };
  // of a file; what pipes hold is not known beforehand
  const auto promised = static_cast<std::size_t>(std::max<off_t>(open.status().st_size, 0));
  demand_few(promised);
  constexpr std::size_t k_block = 1 << 16;
  std::array<char, k_block> block{};
  std::string bytes;
  try {
    bytes.reserve(promised);
    while (const std::size_t count = read_block(open, file, block)) {
      bytes.append(block.data(), count);
      demand_few(bytes.size());
    }
  } catch (const std::bad_alloc&) {
    throw FileError(file.string() + ": too large for the memory that there is");
  }
  return bytes;
}

void demand_file(const fs::path& path) {
  demand_there(path, "file");
  std::error_code fault;
  const fs::file_status found = fs::status(path, fault);
  if (fault) throw FileError(path.string() + ": cannot be opened: " + fault.message());
  if (!fs::is_regular_file(found)) throw FileError(path.string() + ": is no file");
}

bool is_folder(const fs::path& path) {
  demand_there(path, "file or folder");
  std::error_code error;
  const fs::file_status found = fs::status(path, error);
  if (error) throw FileError(path.string() + ": cannot be opened: " + error.message());
  return fs::is_directory(found);
}

}  // namespace nilas
