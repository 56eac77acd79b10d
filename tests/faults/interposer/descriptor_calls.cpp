/// Calls on open files.
#include <errno.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cstdio>

#include "tests/faults/interposer/board.h"
#include "tests/faults/interposer/shadow.h"

using namespace nilas_faults;

#define NEXT(name, ...) static auto* const next = next_of<__VA_ARGS__>(name)
#define REFUSE(due, answer) \
  if ((due).refused()) {    \
    errno = (due).error;    \
    return answer;          \
  }

namespace {

/// How many bytes a write takes: half of them, but at least one, where the plan says so.
std::size_t taken(const Order& due, std::size_t size) { return due.half && size > 1 ? size / 2 : size; }

int descriptor_of(FILE* file) { return ::fileno(file); }

}  // namespace

extern "C" {

ssize_t read(int file, void* to, size_t size) {
  NEXT("read", ssize_t(int, void*, size_t));
  const Order due = order_of(Kind::read, "read", file);
  REFUSE(due, -1)
  return next(file, to, size);
}

ssize_t pread(int file, void* to, size_t size, off_t at) {
  NEXT("pread", ssize_t(int, void*, size_t, off_t));
  const Order due = order_of(Kind::read, "pread", file);
  REFUSE(due, -1)
  return next(file, to, size, at);
}

ssize_t pread64(int file, void* to, size_t size, off64_t at) {
  NEXT("pread64", ssize_t(int, void*, size_t, off64_t));
  const Order due = order_of(Kind::read, "pread64", file);
  REFUSE(due, -1)
  return next(file, to, size, at);
}

size_t fread(void* to, size_t size, size_t count, FILE* file) {
  NEXT("fread", size_t(void*, size_t, size_t, FILE*));
  const Order due = order_of(Kind::read, "fread", descriptor_of(file));
  REFUSE(due, 0)
  return next(to, size, count, file);
}

ssize_t write(int file, const void* from, size_t size) {
  NEXT("write", ssize_t(int, const void*, size_t));
  const Order due = order_of(Kind::write, "write", file);
  REFUSE(due, -1)
  return next(file, from, taken(due, size));
}

ssize_t pwrite(int file, const void* from, size_t size, off_t at) {
  NEXT("pwrite", ssize_t(int, const void*, size_t, off_t));
  const Order due = order_of(Kind::write, "pwrite", file);
  REFUSE(due, -1)
  return next(file, from, taken(due, size), at);
}

ssize_t pwrite64(int file, const void* from, size_t size, off64_t at) {
  NEXT("pwrite64", ssize_t(int, const void*, size_t, off64_t));
  const Order due = order_of(Kind::write, "pwrite64", file);
  REFUSE(due, -1)
  return next(file, from, taken(due, size), at);
}

ssize_t writev(int file, const struct iovec* parts, int count) {
  NEXT("writev", ssize_t(int, const struct iovec*, int));
  const Order due = order_of(Kind::write, "writev", file);
  REFUSE(due, -1)
  return next(file, parts, due.half && count > 1 ? 1 : count);
}

size_t fwrite(const void* from, size_t size, size_t count, FILE* file) {
  NEXT("fwrite", size_t(const void*, size_t, size_t, FILE*));
  const Order due = order_of(Kind::write, "fwrite", descriptor_of(file));
  REFUSE(due, 0)
  return next(from, size, taken(due, count), file);
}

int fflush(FILE* file) {
  NEXT("fflush", int(FILE*));
  if (file != nullptr) {
    const Order due = order_of(Kind::write, "fflush", descriptor_of(file));
    REFUSE(due, EOF)
  }
  return next(file);
}

int fsync(int file) {
  NEXT("fsync", int(int));
  const Order due = order_of(Kind::sync, "fsync", file);
  REFUSE(due, -1)
  note_flushed(file);
  return next(file);
}

int fdatasync(int file) {
  NEXT("fdatasync", int(int));
  const Order due = order_of(Kind::sync, "fdatasync", file);
  REFUSE(due, -1)
  note_flushed(file);
  return next(file);
}

int ftruncate(int file, off_t size) {
  NEXT("ftruncate", int(int, off_t));
  const Order due = order_of(Kind::truncate, "ftruncate", file);
  REFUSE(due, -1)
  return next(file, size);
}

int ftruncate64(int file, off64_t size) {
  NEXT("ftruncate64", int(int, off64_t));
  const Order due = order_of(Kind::truncate, "ftruncate64", file);
  REFUSE(due, -1)
  return next(file, size);
}

// A file whose closing fails is closed all the same.
int close(int file) {
  NEXT("close", int(int));
  const Order due = order_of(Kind::close, "close", file);
  const int closed = next(file);
  REFUSE(due, -1)
  return closed;
}

int fclose(FILE* file) {
  NEXT("fclose", int(FILE*));
  const Order due = order_of(Kind::close, "fclose", descriptor_of(file));
  const int closed = next(file);
  REFUSE(due, EOF)
  return closed;
}

int flock(int file, int operation) {
  NEXT("flock", int(int, int));
  const Order due = order_of(Kind::lock, "flock", file);
  REFUSE(due, -1)
  return next(file, operation);
}
}
