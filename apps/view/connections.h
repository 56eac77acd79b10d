#pragma once
/// Bounds on what clients of a server of this program may keep open. The run needs open files too, and slow clients
/// must not keep others out.
#include <cstddef>
#include <functional>

#include "apps/view/http.h"

namespace nilas::view {

/// Threads that answer clients, with a bound on the connections that wait for one of them: no other is accepted before.
class BoundedPool : public httplib::TaskQueue {
 public:
  BoundedPool(std::size_t threads, std::size_t most_connections) : pool_(threads), most_(most_connections) {}
  void enqueue(std::function<void()> answer) override;
  void shutdown() override { pool_.shutdown(); }

 private:
  httplib::ThreadPool pool_;
  std::size_t most_, open_ = 0;
  std::mutex mutex_;
  std::condition_variable closed_;
};

}  // namespace nilas::view
