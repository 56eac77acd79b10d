#pragma once
/// Which call of a program is to fail. Counters and plan stand in a file that all processes of a command share, so the
/// N-th call is that of the whole tree of processes.
///
/// Variables of the environment:
/// - NILAS_FAULT_BOARD: the file of the counters, as long as a Board and full of zeros at the start;
/// - NILAS_FAULT_CLASS and NILAS_FAULT_AT: the class of calls, and which of them fails, from 1;
/// - NILAS_FAULT_ACTION: the number of an error, `short` for half a write, or `kill` for SIGKILL to all processes;
/// - NILAS_FAULT_LASTING: set where all later calls of the class fail as well;
/// - NILAS_FAULT_UNDER: a folder; calls on other files are not counted;
/// - NILAS_FAULT_SHADOW: a folder that keeps what was flushed to the disk (shadow.h).
#include <sys/types.h>

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace nilas_faults {

/// The classes of calls. `change` counts every call that changes a file or a folder, beside its own class.
enum class Kind {
  open,
  read,
  write,
  sync,
  rename,
  unlink,
  truncate,
  folder,
  close,
  lock,
  stat,
  memory,
  mmap,
  process,
  thread,
  change,
  count
};

constexpr std::size_t k_kinds = static_cast<std::size_t>(Kind::count), k_processes = 64;

/// The shared file; tests/faults/interpose.py reads the same layout.
struct Board {
  std::atomic<std::int64_t> calls[k_kinds];
  std::atomic<std::int64_t> fired;  ///< calls that failed on purpose
  std::int64_t process;             ///< of the first of them
  char program[64], call[64], path[1024];
  std::atomic<std::int64_t> processes;  ///< that have the board
  std::atomic<std::int64_t> ids[k_processes];
};

/// What a call is to do instead of its work.
struct Order {
  int error = 0;      ///< errno of a call that fails; 0: the call does its work
  bool half = false;  ///< a write takes half of its bytes
  bool refused() const { return error != 0; }
};

/// Counts a call and returns what it is to do. Does not return where the plan is to kill.
/// `path`: the file, made absolute, or nullptr where the call has none.
Order order(Kind kind, const char* call, const char* path);

/// The same for a call on a file: counted only below NILAS_FAULT_UNDER. `folder`: the descriptor that `path` is
/// relative to, or AT_FDCWD.
Order order_at(Kind kind, const char* call, int folder, const char* path);
/// The same for a call on a descriptor.
Order order_of(Kind kind, const char* call, int descriptor);

/// Calls are counted from the start of main() to its end.
void arm(bool counts);

/// The absolute path of a file; false where it cannot be told. `size`: bytes of `out`.
bool absolute_path(int folder, const char* path, char* out, std::size_t size);
/// The path of an open file.
bool path_of(int descriptor, char* out, std::size_t size);
/// Whether the plan counts files at this absolute path.
bool is_watched(const char* path);

/// The next function of this name, that of the library.
void* next_function(const char* name);

template <class Function>
Function* next_of(const char* name) {
  return reinterpret_cast<Function*>(next_function(name));
}

}  // namespace nilas_faults
