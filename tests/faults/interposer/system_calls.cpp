/// Memory, processes and threads, and the start of the program.
#include <errno.h>
#include <pthread.h>
#include <spawn.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdio>

#include "tests/faults/interposer/board.h"

using namespace nilas_faults;

#define NEXT(name, ...) static auto* const next = next_of<__VA_ARGS__>(name)
#define REFUSE(kind, name, answer)                                         \
  if (const Order due = order(Kind::kind, name, nullptr); due.refused()) { \
    errno = due.error;                                                     \
    return answer;                                                         \
  }

namespace {

using Main = int(int, char**, char**);
Main* program_main = nullptr;

int counted_main(int count, char** words, char** environment) {
  arm(true);
  const int code = program_main(count, words, environment);
  arm(false);
  return code;
}

}  // namespace

extern "C" {

// The library's functions by their other names: looking them up would need memory.
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* block, size_t size);
void* __libc_memalign(size_t alignment, size_t size);

void* malloc(size_t size) {
  REFUSE(memory, "malloc", nullptr)
  return __libc_malloc(size);
}

void* calloc(size_t count, size_t size) {
  REFUSE(memory, "calloc", nullptr)
  return __libc_calloc(count, size);
}

void* realloc(void* block, size_t size) {
  REFUSE(memory, "realloc", nullptr)
  return __libc_realloc(block, size);
}

void* aligned_alloc(size_t alignment, size_t size) {
  REFUSE(memory, "aligned_alloc", nullptr)
  return __libc_memalign(alignment, size);
}

void* memalign(size_t alignment, size_t size) {
  REFUSE(memory, "memalign", nullptr)
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** out, size_t alignment, size_t size) {
  if (const Order due = order(Kind::memory, "posix_memalign", nullptr); due.refused()) return due.error;
  *out = __libc_memalign(alignment, size);
  return *out == nullptr ? ENOMEM : 0;
}

void* mmap(void* at, size_t size, int protection, int flags, int file, off_t offset) {
  NEXT("mmap", void*(void*, size_t, int, int, int, off_t));
  REFUSE(mmap, "mmap", MAP_FAILED)
  return next(at, size, protection, flags, file, offset);
}

void* mmap64(void* at, size_t size, int protection, int flags, int file, off64_t offset) {
  NEXT("mmap64", void*(void*, size_t, int, int, int, off64_t));
  REFUSE(mmap, "mmap64", MAP_FAILED)
  return next(at, size, protection, flags, file, offset);
}

pid_t fork() {
  NEXT("fork", pid_t());
  REFUSE(process, "fork", -1)
  return next();
}

// A function of ours cannot return twice on one stack, so the child gets a stack of its own.
pid_t vfork() {
  NEXT("fork", pid_t());
  REFUSE(process, "vfork", -1)
  return next();
}

int posix_spawn(pid_t* process, const char* path, const posix_spawn_file_actions_t* actions,
                const posix_spawnattr_t* attributes, char* const* words, char* const* environment) {
  using Spawn = decltype(posix_spawn);
  NEXT("posix_spawn", Spawn);
  if (const Order due = order(Kind::process, "posix_spawn", nullptr); due.refused()) return due.error;
  return next(process, path, actions, attributes, words, environment);
}

int posix_spawnp(pid_t* process, const char* path, const posix_spawn_file_actions_t* actions,
                 const posix_spawnattr_t* attributes, char* const* words, char* const* environment) {
  using Spawn = decltype(posix_spawnp);
  NEXT("posix_spawnp", Spawn);
  if (const Order due = order(Kind::process, "posix_spawnp", nullptr); due.refused()) return due.error;
  return next(process, path, actions, attributes, words, environment);
}

int system(const char* command) {
  NEXT("system", int(const char*));
  REFUSE(process, "system", -1)
  return next(command);
}

int execv(const char* path, char* const* words) {
  NEXT("execv", int(const char*, char* const*));
  REFUSE(process, "execv", -1)
  return next(path, words);
}

int execve(const char* path, char* const* words, char* const* environment) {
  NEXT("execve", int(const char*, char* const*, char* const*));
  REFUSE(process, "execve", -1)
  return next(path, words, environment);
}

int execvp(const char* file, char* const* words) {
  NEXT("execvp", int(const char*, char* const*));
  REFUSE(process, "execvp", -1)
  return next(file, words);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*begin)(void*), void* argument) {
  using Create = decltype(pthread_create);
  NEXT("pthread_create", Create);
  if (const Order due = order(Kind::thread, "pthread_create", nullptr); due.refused()) return due.error;
  return next(thread, attributes, begin, argument);
}

int __libc_start_main(Main* main, int count, char** words, void (*init)(), void (*end)(), void (*loader_end)(),
                      void* stack) {
  using Start = int(Main*, int, char**, void (*)(), void (*)(), void (*)(), void*);
  NEXT("__libc_start_main", Start);
  program_main = main;
  return next(counted_main, count, words, init, end, loader_end, stack);
}
}
