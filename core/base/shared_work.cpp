#include "core/base/shared_work.h"

#include <atomic>
#include <cstddef>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace nilas {

namespace {

/// Looks at a number that another thread is about to change, before the thread that waits goes to sleep: some 100
/// microseconds. Loops of a solve follow each other within that time, and waking a thread takes as long as such a loop.
constexpr int k_looks = 10000;

void pause_processor() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

void wait_while(const std::atomic<int>& number, int value) {
  for (int look = 0; look < k_looks; ++look) {
    if (number.load(std::memory_order_acquire) != value) return;
    pause_processor();
  }
  number.wait(value, std::memory_order_acquire);
}

/// Whether this thread does shared work. It is aligned as the sections that follow it: mold 1.10 lets the part that
/// becomes read-only begin here, and without that the part may begin on a page that is not mapped, so that no program
/// starts.
alignas(alignof(std::max_align_t)) thread_local bool is_sharing = false;

class Helpers {
 public:
  /// Returns false if another thread's work is under way.
  bool share(int threads, void (*call)(const void*), const void* body) {
    const std::unique_lock alone(in_use_, std::try_to_lock);
    if (!alone) return false;
    call_helpers(threads - 1);
    {
      const std::lock_guard lock(mutex_);
      call_ = call;
      body_ = body;
      places_ = threads - 1;
      works_.fetch_add(1, std::memory_order_release);
    }
    works_.notify_all();
    is_sharing = true;
    call(body);
    is_sharing = false;
    {
      const std::lock_guard lock(mutex_);
      places_ = 0;
    }
    for (int busy = busy_.load(std::memory_order_acquire); busy > 0; busy = busy_.load(std::memory_order_acquire))
      wait_while(busy_, busy);
    return true;
  }

 private:
  void help() {
    is_sharing = true;
    for (int seen = 0;; wait_while(works_, seen)) {
      {
        const std::lock_guard lock(mutex_);
        seen = works_.load(std::memory_order_relaxed);
        if (places_ == 0) continue;
        --places_;
        busy_.fetch_add(1, std::memory_order_relaxed);
      }
      call_(body_);
      if (busy_.fetch_sub(1, std::memory_order_release) == 1) busy_.notify_one();
    }
  }

  /// Makes helpers up to this number, or as many as the system grants.
  void call_helpers(int count) {
    try {
      while (static_cast<int>(helpers_.size()) < count) helpers_.emplace_back([this] { help(); });
    } catch (const std::system_error&) {
    }
  }

  std::mutex in_use_;
  std::mutex mutex_;
  void (*call_)(const void*) = nullptr;
  const void* body_ = nullptr;
  int places_ = 0;             ///< helpers that may still join
  std::atomic<int> works_{0};  ///< begun so far
  std::atomic<int> busy_{0};   ///< helpers in the work
  std::vector<std::thread> helpers_;
};

}  // namespace

void share_work(int threads, void (*call)(const void*), const void* body) {
  // never destroyed: the helpers sleep until the program ends; a child of fork() has none and must call exec first
  static Helpers& helpers = *new Helpers;
  if (threads > 1 && !is_sharing && helpers.share(threads, call, body)) return;
  call(body);
}

}  // namespace nilas
