/// Calls on files by their names.
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>

#include "tests/faults/interposer/board.h"
#include "tests/faults/interposer/shadow.h"

using namespace nilas_faults;

// Each function looks for the next of its name, and calls it unless the plan is that it fails.
#define NEXT(name, ...) static auto* const next = next_of<__VA_ARGS__>(name)
#define REFUSE(kind, name, folder, path, answer)                                   \
  if (const Order due = order_at(Kind::kind, name, folder, path); due.refused()) { \
    errno = due.error;                                                             \
    return answer;                                                                 \
  }

namespace {

using Open = int(const char*, int, ...);
using OpenAt = int(int, const char*, int, ...);
using FileOpen = FILE*(const char*, const char*);

/// The mode of a call that may create a file.
#define MODE_OF(flags)                             \
  mode_t mode = 0;                                 \
  if (((flags) & (O_CREAT | O_TMPFILE)) != 0) {    \
    va_list more;                                  \
    va_start(more, flags);                         \
    mode = static_cast<mode_t>(va_arg(more, int)); \
    va_end(more);                                  \
  }

void before_removal(int folder, const char* path) {
  char absolute[1024];
  if (absolute_path(folder, path, absolute, sizeof absolute)) note_removed(absolute);
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  NEXT("open", Open);
  MODE_OF(flags)
  REFUSE(open, "open", AT_FDCWD, path, -1)
  return next(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  NEXT("open64", Open);
  MODE_OF(flags)
  REFUSE(open, "open64", AT_FDCWD, path, -1)
  return next(path, flags, mode);
}

int __open64_2(const char* path, int flags) {
  NEXT("__open64_2", int(const char*, int));
  REFUSE(open, "open64", AT_FDCWD, path, -1)
  return next(path, flags);
}

int openat(int folder, const char* path, int flags, ...) {
  NEXT("openat", OpenAt);
  MODE_OF(flags)
  REFUSE(open, "openat", folder, path, -1)
  return next(folder, path, flags, mode);
}

int openat64(int folder, const char* path, int flags, ...) {
  NEXT("openat64", OpenAt);
  MODE_OF(flags)
  REFUSE(open, "openat64", folder, path, -1)
  return next(folder, path, flags, mode);
}

FILE* fopen(const char* path, const char* mode) {
  NEXT("fopen", FileOpen);
  REFUSE(open, "fopen", AT_FDCWD, path, nullptr)
  return next(path, mode);
}

FILE* fopen64(const char* path, const char* mode) {
  NEXT("fopen64", FileOpen);
  REFUSE(open, "fopen64", AT_FDCWD, path, nullptr)
  return next(path, mode);
}

int rename(const char* from, const char* to) {
  NEXT("rename", int(const char*, const char*));
  REFUSE(rename, "rename", AT_FDCWD, to, -1)
  before_removal(AT_FDCWD, to);
  return next(from, to);
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) {
  NEXT("renameat", int(int, const char*, int, const char*));
  REFUSE(rename, "renameat", to_folder, to, -1)
  before_removal(to_folder, to);
  return next(from_folder, from, to_folder, to);
}

int unlink(const char* path) {
  NEXT("unlink", int(const char*));
  REFUSE(unlink, "unlink", AT_FDCWD, path, -1)
  before_removal(AT_FDCWD, path);
  return next(path);
}

int unlinkat(int folder, const char* path, int flags) {
  NEXT("unlinkat", int(int, const char*, int));
  REFUSE(unlink, "unlinkat", folder, path, -1)
  before_removal(folder, path);
  return next(folder, path, flags);
}

int remove(const char* path) {
  NEXT("remove", int(const char*));
  REFUSE(unlink, "remove", AT_FDCWD, path, -1)
  before_removal(AT_FDCWD, path);
  return next(path);
}

int rmdir(const char* path) {
  NEXT("rmdir", int(const char*));
  REFUSE(unlink, "rmdir", AT_FDCWD, path, -1)
  return next(path);
}

int truncate(const char* path, off_t size) {
  NEXT("truncate", int(const char*, off_t));
  REFUSE(truncate, "truncate", AT_FDCWD, path, -1)
  return next(path, size);
}

int mkdir(const char* path, mode_t mode) {
  NEXT("mkdir", int(const char*, mode_t));
  REFUSE(folder, "mkdir", AT_FDCWD, path, -1)
  return next(path, mode);
}

DIR* opendir(const char* path) {
  NEXT("opendir", DIR * (const char*));
  REFUSE(folder, "opendir", AT_FDCWD, path, nullptr)
  return next(path);
}

int stat(const char* path, struct stat* out) {
  NEXT("stat", int(const char*, struct stat*));
  REFUSE(stat, "stat", AT_FDCWD, path, -1)
  return next(path, out);
}

int stat64(const char* path, struct stat64* out) {
  NEXT("stat64", int(const char*, struct stat64*));
  REFUSE(stat, "stat64", AT_FDCWD, path, -1)
  return next(path, out);
}

int lstat(const char* path, struct stat* out) {
  NEXT("lstat", int(const char*, struct stat*));
  REFUSE(stat, "lstat", AT_FDCWD, path, -1)
  return next(path, out);
}

int lstat64(const char* path, struct stat64* out) {
  NEXT("lstat64", int(const char*, struct stat64*));
  REFUSE(stat, "lstat64", AT_FDCWD, path, -1)
  return next(path, out);
}

int fstatat64(int folder, const char* path, struct stat64* out, int flags) {
  NEXT("fstatat64", int(int, const char*, struct stat64*, int));
  REFUSE(stat, "fstatat64", folder, path, -1)
  return next(folder, path, out, flags);
}
}
