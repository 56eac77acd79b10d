#include "tests/faults/interposer/board.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace nilas_faults {

namespace {

constexpr const char* k_names[k_kinds] = {"open",     "read",    "write",  "sync",  "rename", "unlink",
                                          "truncate", "folder",  "close",  "lock",  "stat",   "memory",
                                          "mmap",     "process", "thread", "change"};
constexpr std::size_t k_path = 1024;

/// The plan of this process, from its environment.
struct Plan {
  Board* board = nullptr;
  int kind = -1;
  std::int64_t at = 0;
  int error = 0;
  bool half = false, kills = false, lasting = false, armed = false;
  char under[k_path] = {};
  std::size_t under_size = 0;
};

Plan plan;

/// The file is mapped by system calls: the library's own functions are those that are counted.
Board* shared_board(const char* file) {
  const long descriptor = ::syscall(SYS_openat, AT_FDCWD, file, O_RDWR | O_CLOEXEC, 0);
  if (descriptor < 0) return nullptr;
  const long at = ::syscall(SYS_mmap, nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  ::syscall(SYS_close, descriptor);
  return at > 0 ? reinterpret_cast<Board*>(at) : nullptr;
}

void read_action(const char* action) {
  plan.half = std::strcmp(action, "short") == 0;
  plan.kills = std::strcmp(action, "kill") == 0;
  if (!plan.half && !plan.kills) plan.error = std::atoi(action);
}

void enrol() {
  const std::int64_t place = plan.board->processes++;
  if (place < static_cast<std::int64_t>(k_processes)) plan.board->ids[place] = ::syscall(SYS_getpid);
}

__attribute__((constructor)) void read_plan() {
  const char* file = std::getenv("NILAS_FAULT_BOARD");
  if (file == nullptr || (plan.board = shared_board(file)) == nullptr) return;
  enrol();
  if (const char* under = std::getenv("NILAS_FAULT_UNDER")) {
    std::snprintf(plan.under, sizeof plan.under, "%s", under);
    plan.under_size = std::strlen(plan.under);
  }
  const char *kind = std::getenv("NILAS_FAULT_CLASS"), *at = std::getenv("NILAS_FAULT_AT"),
             *action = std::getenv("NILAS_FAULT_ACTION");
  if (kind == nullptr || at == nullptr || action == nullptr) return;
  for (std::size_t k = 0; k < k_kinds; ++k)
    if (std::strcmp(kind, k_names[k]) == 0) plan.kind = static_cast<int>(k);
  plan.at = std::atoll(at);
  plan.lasting = std::getenv("NILAS_FAULT_LASTING") != nullptr;
  read_action(action);
}

/// Kills all processes that have the board: the machine loses its power.
[[noreturn]] void kill_all() {
  const long own = ::syscall(SYS_getpid);
  const std::int64_t count = plan.board->processes;
  for (std::int64_t k = 0; k < count && k < static_cast<std::int64_t>(k_processes); ++k)
    if (plan.board->ids[k] != own) ::syscall(SYS_kill, plan.board->ids[k].load(), SIGKILL);
  ::syscall(SYS_kill, own, SIGKILL);
  for (;;) ::syscall(SYS_pause);
}

bool is_due(Kind kind, std::int64_t number) {
  if (plan.kind != static_cast<int>(kind)) return false;
  return number == plan.at || (plan.lasting && number > plan.at);
}

void note(const char* call, const char* path) {
  if (plan.board->fired++ > 0) return;
  plan.board->process = ::syscall(SYS_getpid);
  std::snprintf(plan.board->program, sizeof plan.board->program, "%s", program_invocation_short_name);
  std::snprintf(plan.board->call, sizeof plan.board->call, "%s", call);
  std::snprintf(plan.board->path, sizeof plan.board->path, "%s", path == nullptr ? "" : path);
}

bool changes(Kind kind, const char* call) {
  switch (kind) {
    case Kind::write:
    case Kind::sync:
    case Kind::rename:
    case Kind::unlink:
    case Kind::truncate:
    case Kind::close:
      return true;
    case Kind::folder:
      return std::strncmp(call, "mkdir", std::strlen("mkdir")) == 0;
    default:
      return false;
  }
}

Order count(Kind kind, const char* call, const char* path) {
  const std::int64_t number = ++plan.board->calls[static_cast<std::size_t>(kind)];
  if (!is_due(kind, number)) return {};
  note(call, path);
  if (plan.kills) kill_all();
  return {plan.error, plan.half};
}

}  // namespace

void arm(bool counts) { plan.armed = counts; }

Order order(Kind kind, const char* call, const char* path) {
  if (!plan.armed || plan.board == nullptr) return {};
  const Order own = count(kind, call, path);
  if (own.refused() || own.half || !changes(kind, call)) return own;
  return count(Kind::change, call, path);
}

bool path_of(int descriptor, char* out, std::size_t size) {
  char link[64];
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const long length = ::syscall(SYS_readlinkat, AT_FDCWD, link, out, size - 1);
  if (length <= 0) return false;
  out[length] = '\0';
  return out[0] == '/';
}

bool absolute_path(int folder, const char* path, char* out, std::size_t size) {
  if (path == nullptr) return false;
  if (path[0] == '/') return std::snprintf(out, size, "%s", path) < static_cast<int>(size);
  char base[k_path];
  if (folder != AT_FDCWD) {
    if (!path_of(folder, base, sizeof base)) return false;
  } else if (::syscall(SYS_getcwd, base, sizeof base) <= 0) {
    return false;
  }
  return std::snprintf(out, size, "%s/%s", base, path) < static_cast<int>(size);
}

bool is_watched(const char* path) {
  if (plan.under_size == 0) return true;
  return std::strncmp(path, plan.under, plan.under_size) == 0;
}

Order order_at(Kind kind, const char* call, int folder, const char* path) {
  if (!plan.armed || plan.board == nullptr) return {};
  const int before = errno;
  char absolute[k_path];
  const bool known = absolute_path(folder, path, absolute, sizeof absolute);
  errno = before;
  return known && is_watched(absolute) ? order(kind, call, absolute) : Order{};
}

Order order_of(Kind kind, const char* call, int descriptor) {
  if (!plan.armed || plan.board == nullptr) return {};
  const int before = errno;
  char path[k_path];
  const bool known = path_of(descriptor, path, sizeof path);
  errno = before;
  return known && is_watched(path) ? order(kind, call, path) : Order{};
}

void* next_function(const char* name) { return ::dlsym(RTLD_NEXT, name); }

}  // namespace nilas_faults
