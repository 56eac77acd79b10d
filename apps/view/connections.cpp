#include "apps/view/connections.h"

#include <utility>

namespace nilas::view {

void BoundedPool::enqueue(std::function<void()> answer) {
  {
    std::unique_lock lock(mutex_);
    closed_.wait(lock, [this] { return open_ < most_; });
    ++open_;
  }
  pool_.enqueue([this, answer = std::move(answer)] {
    answer();
    const std::lock_guard lock(mutex_);
    --open_;
    closed_.notify_one();
  });
}

}  // namespace nilas::view
