#pragma once
/// Runs tasks in processes of their own, a core for each. A task that hangs or crashes then costs no more than its time
/// limit, and a timed task stays on its core.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace nilas::compare {

/// One process to run.
struct ChildTask {
  std::vector<std::string> command;   ///< program and arguments; no shell reads them
  std::filesystem::path output, log;  ///< files for its standard output and error, which are created
  double limit_s = 0;                 ///< wall time after which it is ended [s]; 0: none
};

/// How a process ended.
struct ChildResult {
  int exit_code = -1;      ///< exit code; 128 + signal if a signal ended it
  bool timed_out = false;  ///< ended at its limit
  bool stopped = false;    ///< ended, or never begun, because `stop` returned true
  double cpu_s = 0;        ///< processor time of the process and of the system for it [s]
  double wall_s = 0;       ///< wall time [s]
};

/// The number of cores that this process may use.
int usable_cores();

/// The hooks of run_children(). `begin(k, task)` may change a task, such as its limit, or refuse it by returning false;
/// it then never begins, and `ended` is not called. `ended(k, result)` is called on the calling thread as each task
/// ends. When `stop` turns true, running children are asked to end (SIGTERM, then SIGKILL after 10 s) and no more
/// begin.
struct ChildHooks {
  std::function<bool(std::size_t, ChildTask&)> begin;
  std::function<void(std::size_t, const ChildResult&)> ended;
  std::function<bool()> stop;
};
/// Runs the tasks in their order, `jobs` at a time. Each is pinned to a core of its own, which tasks share if there are
/// fewer cores, and gets one thread for OpenMP and OpenBLAS. Children are killed when this process ends in any way.
/// Throws FileError if a process cannot be started or its files cannot be written.
void run_children(std::vector<ChildTask> tasks, int jobs, const ChildHooks& hooks);

/// Runs one task, pinned to a core.
ChildResult run_child(const ChildTask& task, const std::function<bool()>& stop = {});

/// The file of this program, for running it again. Throws FileError.
std::filesystem::path own_program();

}  // namespace nilas::compare
