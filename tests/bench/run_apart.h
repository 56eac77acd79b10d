#pragma once
/// Work in a process of its own, so that what hangs, crashes or eats memory costs no more than its time limit.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <type_traits>

namespace nilas::bench {

/// Calls `work` in a child process that is ended after about `limit` seconds and copies what it returns to `result`.
/// False when it did not end in time or not well. `peak`: most memory that the child held [bytes].
template <class Result, class Work>
bool run_apart(double limit, const Work& work, Result& result, double* peak = nullptr) {
  static_assert(std::is_trivially_copyable_v<Result>);
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return false;
  std::fflush(stdout);  // or the child would print it again
  const pid_t child = fork();
  if (child == 0) {
    if (std::freopen("/dev/null", "w", stdout) == nullptr) _exit(1);  // some peers talk
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
