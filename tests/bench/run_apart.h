#pragma once
/// Runs work in a process of its own, so that a hang, a crash or a leak costs no more than the time limit.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <type_traits>

namespace nilas::bench {

/// Calls `work` in a child process that is killed after about `limit` seconds, and copies its return value to `result`.
/// False when the child did not end in time or failed. `peak`: largest memory of the child [bytes].
template <class Result, class Work>
bool run_apart(double limit, const Work& work, Result& result, double* peak = nullptr) {
  static_assert(std::is_trivially_copyable_v<Result>);
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return false;
  std::fflush(stdout);  // Otherwise the child would print the buffered text again.
  const pid_t child = fork();
  if (child == 0) {
    if (std::freopen("/dev/null", "w", stdout) == nullptr) _exit(1);  // Some peers print messages.
    alarm(static_cast<unsigned>(std::ceil(limit)));
    const Result mine = work();
    _exit(write(ends[1], &mine, sizeof mine) == static_cast<ssize_t>(sizeof mine) ? 0 : 1);
  }
  close(ends[1]);
  const bool done = read(ends[0], &result, sizeof result) == static_cast<ssize_t>(sizeof result);
  close(ends[0]);
  rusage usage{};
  wait4(child, nullptr, 0, &usage);
  if (peak != nullptr) *peak = 1024.0 * static_cast<double>(usage.ru_maxrss);
  return done;
}

}  // namespace nilas::bench
