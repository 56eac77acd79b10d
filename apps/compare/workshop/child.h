#pragma once
/// Work in processes of their own, a core for each, so that what hangs or crashes costs no more than its time limit and
/// what is timed is not moved about.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace nilas {

/// One process to run.
struct ChildTask {
  std::vector<std::string> command;   ///< program and arguments, no shell in between
  std::filesystem::path output, log;  ///< of its standard output and error; created
  double limit_s = 0;                 ///< wall time after which it is ended; 0: none [s]
};

/// How a process ended.
struct ChildResult {
  int exit_code = -1;      ///< 128 + signal where a signal ended it
  bool timed_out = false;  ///< ended at its limit
  bool stopped = false;    ///< ended, or never begun, because `stop` said so
  double cpu_s = 0;        ///< processor time, its own and the system's on its behalf [s]
  double wall_s = 0;       ///< [s]
};

/// Cores that this process may use.
int usable_cores();

/// Runs the tasks in their order, `jobs` at a time, each pinned to a core of its own (they share where there are fewer)
/// with one thread for libraries that would take more. `begin(k)` may shorten a task's limit or refuse it (false: it
/// never begins, `ended` is not called). `ended(k, result)` is called on the calling thread as each ends. When `stop`
/// turns true, running children are asked to end (SIGTERM, SIGKILL after 10 s) and no more begin. Children are killed
/// with this process whatever ends it. Throws FileError when a process cannot be made or its files cannot be written.
struct ChildHooks {
  std::function<bool(std::size_t, ChildTask&)> begin;
  std::function<void(std::size_t, const ChildResult&)> ended;
  std::function<bool()> stop;
};
void run_children(std::vector<ChildTask> tasks, int jobs, const ChildHooks& hooks);

/// One task alone on its core.
ChildResult run_child(const ChildTask& task, const std::function<bool()>& stop = {});

/// This program's own file, to run again.
std::filesystem::path own_program();

}  // namespace nilas
