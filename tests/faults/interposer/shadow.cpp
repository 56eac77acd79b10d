#include "tests/faults/interposer/shadow.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tests/faults/interposer/board.h"

namespace nilas_faults {

namespace {

constexpr std::size_t k_path = 2048;
constexpr int k_mode = 0644;

/// Entries of a folder as the system call returns them.
struct Entry {
  std::uint64_t inode;
  std::int64_t next;
  unsigned short size;
  unsigned char type;
  char name[1];
};

const char* shadow() { return std::getenv("NILAS_FAULT_SHADOW"); }

long open_file(const char* path, int flags) { return ::syscall(SYS_openat, AT_FDCWD, path, flags | O_CLOEXEC, k_mode); }

void write_line(const char* line) {
  char path[k_path];
  std::snprintf(path, sizeof path, "%s/journal", shadow());
  const long file = open_file(path, O_WRONLY | O_CREAT | O_APPEND);
  if (file < 0) return;
  ::syscall(SYS_write, file, line, std::strlen(line));
  ::syscall(SYS_close, file);
}

void copy_content(const char* from, unsigned long inode) {
  char to[k_path];
  std::snprintf(to, sizeof to, "%s/files/%lu", shadow(), inode);
  const long in = open_file(from, O_RDONLY), out = open_file(to, O_WRONLY | O_CREAT | O_TRUNC);
  char block[1 << 14];
  for (long got = 1; in >= 0 && out >= 0 && got > 0;) {
    got = ::syscall(SYS_read, in, block, sizeof block);
    if (got > 0) ::syscall(SYS_write, out, block, got);
  }
  if (in >= 0) ::syscall(SYS_close, in);
  if (out >= 0) ::syscall(SYS_close, out);
}

void list_folder(const char* path) {
  const long folder = open_file(path, O_RDONLY | O_DIRECTORY);
  if (folder < 0) return;
  alignas(Entry) char block[1 << 14];
  char line[k_path];
  for (long got; (got = ::syscall(SYS_getdents64, folder, block, sizeof block)) > 0;) {
    for (long at = 0; at < got;) {
      const auto* entry = reinterpret_cast<const Entry*>(block + at);
      const char* name = block + at + offsetof(Entry, name);
      std::snprintf(line, sizeof line, "%c %lu %s\n", entry->type == DT_DIR ? 'S' : 'E',
                    static_cast<unsigned long>(entry->inode), name);
      write_line(line);
      at += entry->size;
    }
  }
  ::syscall(SYS_close, folder);
}

}  // namespace

void note_flushed(int descriptor) {
  if (shadow() == nullptr) return;
  const int before = errno;
  char path[k_path], line[k_path + 64];
  struct stat status {};
  if (path_of(descriptor, path, sizeof path) && is_watched(path) &&
      ::syscall(SYS_newfstatat, AT_FDCWD, path, &status, 0) == 0) {
    if (S_ISDIR(status.st_mode)) {
      std::snprintf(line, sizeof line, "D %s\n", path);
      write_line(line);
      list_folder(path);
    } else {
      copy_content(path, status.st_ino);
      std::snprintf(line, sizeof line, "F %lu %s\n", static_cast<unsigned long>(status.st_ino), path);
      write_line(line);
    }
  }
  errno = before;
}

void note_removed(const char* path) {
  if (shadow() == nullptr || !is_watched(path)) return;
  const int before = errno;
  struct stat status {};
  if (::syscall(SYS_newfstatat, AT_FDCWD, path, &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(status.st_mode)) {
    char kept[k_path];
    std::snprintf(kept, sizeof kept, "%s/kept/%lu", shadow(), static_cast<unsigned long>(status.st_ino));
    ::syscall(SYS_linkat, AT_FDCWD, path, AT_FDCWD, kept, 0);
  }
  errno = before;
}

}  // namespace nilas_faults
