#pragma once
/// Runs independent jobs on several threads.
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace nilas::verify {

/// Calls work(k) once for each k in [0, count), in any order. The calling thread calls `done` with the share of jobs
/// that has begun. After an exception no further job begins, and the first exception is thrown again.
template <class Work>
void run_jobs(std::size_t count, int threads, const Work& work, const std::function<void(double)>& done) {
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::exception_ptr failure;
  const auto take = [&](bool reports) {
    for (std::size_t k = next++; k < count && !failed; k = next++) {
      try {
        work(k);
      } catch (...) {
        if (!failed.exchange(true)) failure = std::current_exception();
      }
      if (reports && done) done(static_cast<double>(k + 1) / static_cast<double>(count));
    }
  };
  {
    std::vector<std::jthread> others;
    for (int k = 1; k < threads; ++k) others.emplace_back(take, false);
    take(true);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace nilas::verify
