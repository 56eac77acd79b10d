#pragma once
/// Loop over independent items. Each item writes only its own result, so the bits do not depend on the thread count.
#include <algorithm>
#include <cstddef>
#include <exception>
#include <mutex>

namespace nilas {

/// The first exception of a loop's items, which must not leave the thread that runs them.
class LoopException {
 public:
  template <class Body>
  void guard(const Body& body, std::ptrdiff_t i) {
    try {
      body(i);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!first_) first_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr first_;
};

/// Rethrows an exception of an item after all others have run; of several, any one.
template <class Body>
void parallel_for(std::ptrdiff_t count, int threads, const Body& body) {
  LoopException thrown;
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (std::ptrdiff_t i = 0; i < count; ++i) thrown.guard(body, i);
  thrown.rethrow();
}

/// The same for few pieces of uneven length: a thread that is done with one takes the next.
template <class Body>
void parallel_pieces(std::ptrdiff_t count, int threads, const Body& body) {
  LoopException thrown;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads) if (threads > 1)
  for (std::ptrdiff_t i = 0; i < count; ++i) thrown.guard(body, i);
  thrown.rethrow();
}

/// Items per chunk of a loop whose chunks are summed apart.
constexpr std::ptrdiff_t k_chunk = 256;

inline std::ptrdiff_t num_chunks(std::ptrdiff_t count, std::ptrdiff_t chunk = k_chunk) {
  return (count + chunk - 1) / chunk;
}

/// Calls body(k, first, last) for the chunks k of [0, count), whose number does not depend on the thread count.
template <class Body>
void parallel_chunks(std::ptrdiff_t count, std::ptrdiff_t chunk, int threads, const Body& body) {
  parallel_for(num_chunks(count, chunk), threads,
               [&](std::ptrdiff_t k) { body(k, k * chunk, std::min(count, (k + 1) * chunk)); });
}

}  // namespace nilas
