#include "apps/compare/workshop/child.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "core/base/error.h"

namespace nilas::compare {

namespace {

constexpr double k_patience_s = 10;  // between SIGTERM and SIGKILL
constexpr auto k_poll = std::chrono::milliseconds(3);

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::vector<int> allowed_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  std::vector<int> cores;
  if (sched_getaffinity(0, sizeof set, &set) == 0)
    for (int k = 0; k < CPU_SETSIZE; ++k)
      if (CPU_ISSET(k, &set)) cores.push_back(k);
  if (cores.empty()) cores.push_back(0);
  return cores;
}

int open_for_child(const std::filesystem::path& file) {
  const int descriptor =
      ::open(file.empty() ? "/dev/null" : file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) throw FileError(file.string() + ": cannot be written: " + std::strerror(errno));
  return descriptor;
}

/// Turns the child into the program of its task. It makes only calls that are safe after fork().
[[noreturn]] void become(char* const* arguments, int out, int log, int core, pid_t parent, const sigset_t& unblocked) {
  // in a group of its own, so that Ctrl-C on the terminal reaches only the parent, which ends its children in order
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(k_exit_not_started);
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(core, &set);
  ::sched_setaffinity(0, sizeof set, &set);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  ::signal(SIGINT, SIG_DFL);
  ::signal(SIGTERM, SIG_DFL);
  ::sigprocmask(SIG_SETMASK, &unblocked, nullptr);
  ::execv(arguments[0], arguments);
  ::_exit(k_exit_not_started);
}

/// A process that runs.
struct Running {
  std::size_t task = 0;
  pid_t process = 0;
  int slot = 0;
  Clock::time_point started;
  double limit_s = 0;
  double asked_to_end_s = -1;  ///< time since `started` when it was asked to end [s]; below 0: it was not
  bool timed_out = false, stopped = false;
};

Running start(std::size_t index, const ChildTask& task, int slot, int core) {
  std::vector<std::string> words = task.command;
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int out = open_for_child(task.output), log = open_for_child(task.log);
  const pid_t parent = ::getpid();
  Running running{index, 0, slot, Clock::now(), task.limit_s};
  // a signal that comes while the child still has this program's handlers would be lost
  sigset_t ends, unblocked;
  ::sigemptyset(&ends);
  ::sigaddset(&ends, SIGTERM);
  ::sigaddset(&ends, SIGINT);
  ::sigprocmask(SIG_BLOCK, &ends, &unblocked);
  running.process = ::fork();
  if (running.process == 0) become(arguments.data(), out, log, core, parent, unblocked);
  ::sigprocmask(SIG_SETMASK, &unblocked, nullptr);
  ::close(out);
  ::close(log);
  if (running.process < 0) throw FileError("cannot start " + task.command.front() + ": " + std::strerror(errno));
  return running;
}

/// Asks a child to end, and kills it if it has not ended 10 s later.
void press(Running& child) {
  const double t = since(child.started);
  if (child.asked_to_end_s < 0) {
    ::kill(child.process, SIGTERM);
    child.asked_to_end_s = t;
  } else if (t > child.asked_to_end_s + k_patience_s) {
    ::kill(child.process, SIGKILL);
  }
}

bool ended(Running& child, ChildResult& result) {
  int status = 0;
  rusage usage{};
  if (::wait4(child.process, &status, WNOHANG, &usage) != child.process) return false;
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : k_exit_signal + WTERMSIG(status);
  result.timed_out = child.timed_out;
  result.stopped = child.stopped;
  result.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  result.wall_s = since(child.started);
  return true;
}

/// The running children. Those that still run when an exception leaves the scope are killed.
struct Nursery {
  std::vector<Running> running;
  ~Nursery() {
    for (const auto& child : running) {
      ::kill(child.process, SIGKILL);
      ::waitpid(child.process, nullptr, 0);
    }
  }
};

int free_slot(const std::vector<Running>& running) {
  int slot = 0;
  while (std::any_of(running.begin(), running.end(), [&](const Running& r) { return r.slot == slot; })) ++slot;
  return slot;
}

}  // namespace

int usable_cores() { return static_cast<int>(allowed_cores().size()); }

void run_children(std::vector<ChildTask> tasks, int jobs, const ChildHooks& hooks) {
  ::setenv("OMP_NUM_THREADS", "1", 1);
  ::setenv("OPENBLAS_NUM_THREADS", "1", 1);
  const std::vector<int> cores = allowed_cores();
  Nursery nursery;
  std::vector<Running>& running = nursery.running;
  std::size_t next = 0;
  for (;;) {
    const bool stop = hooks.stop && hooks.stop();
    for (; !stop && next < tasks.size() && running.size() < static_cast<std::size_t>(jobs); ++next) {
      if (hooks.begin && !hooks.begin(next, tasks[next])) continue;
      const int slot = free_slot(running);
      running.push_back(start(next, tasks[next], slot, cores[static_cast<std::size_t>(slot) % cores.size()]));
    }
    if (running.empty()) return;
    std::vector<std::pair<std::size_t, ChildResult>> gone;
    for (auto child = running.begin(); child != running.end();) {
      ChildResult result;
      if (ended(*child, result)) {
        gone.emplace_back(child->task, result);
        child = running.erase(child);
        continue;
      }
      child->stopped = child->stopped || (stop && !child->timed_out);
      child->timed_out =
          child->timed_out || (!child->stopped && child->limit_s > 0 && since(child->started) > child->limit_s);
      if (child->stopped || child->timed_out) press(*child);
      ++child;
    }
    if (hooks.ended)
      for (const auto& [task, result] : gone) hooks.ended(task, result);
    if (!gone.empty()) continue;
    std::this_thread::sleep_for(k_poll);
  }
}

ChildResult run_child(const ChildTask& task, const std::function<bool()>& stop) {
  ChildResult result;
  result.stopped = true;
  run_children({task}, 1, {{}, [&](std::size_t, const ChildResult& r) { result = r; }, stop});
  return result;
}

std::filesystem::path own_program() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw FileError("/proc/self/exe: " + error.message());
  return program;
}

}  // namespace nilas::compare
