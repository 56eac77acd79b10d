#pragma once
/// Loop over independent items. Each item writes only its own result, so the bits do not depend on the thread count.
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>

#include "core/base/shared_work.h"

namespace nilas {

/// The first exception of a loop's items, which must not leave the thread that runs them.
class LoopException {
 public:
  template <class Body, class Item>
  void guard(const Body& body, const Item& item) {
    try {
      body(item);
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

/// Calls body(i) for all items; threads take blocks of them. Rethrows an exception of an item after all others have
/// run; of several, any one.
template <class Body>
void parallel_blocks(std::ptrdiff_t count, std::ptrdiff_t block, int threads, const Body& body) {
  LoopException thrown;
  std::atomic<std::ptrdiff_t> next = 0;
  const auto run = [&] {
    for (std::ptrdiff_t i = next.fetch_add(block); i < count; i = next.fetch_add(block))
      for (std::ptrdiff_t k = i; k < std::min(count, i + block); ++k) thrown.guard(body, k);
  };
  share_work(count > block ? threads : 1, run);
  thrown.rethrow();
}

/// For many items of about equal length.
template <class Body>
void parallel_for(std::ptrdiff_t count, int threads, const Body& body) {
  constexpr std::ptrdiff_t k_blocks_per_thread = 4;  // so that a thread that is slow or late holds up few items
  const std::ptrdiff_t blocks = threads > 1 ? k_blocks_per_thread * threads : 1;
  parallel_blocks(count, std::max<std::ptrdiff_t>(1, count / blocks), threads, body);
}

/// For few items of uneven length.
template <class Body>
void parallel_pieces(std::ptrdiff_t count, int threads, const Body& body) {
  parallel_blocks(count, 1, threads, body);
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
