#pragma once
/// Runs the tasks of a NodePlan, each after those that it needs.
#include <atomic>
#include <span>
#include <thread>
#include <vector>

#include "contact/solvers/bodies/node_plan.h"
#include "core/base/parallel.h"

namespace nilas::solvers {

/// Which tasks of a run are done.
class TaskProgress {
 public:
  explicit TaskProgress(int num_tasks) : flags_(static_cast<std::size_t>(num_tasks)) {}

  void begin() {
    for (Flag& flag : flags_) flag.is_done.store(false, std::memory_order_relaxed);
    next_.store(0, std::memory_order_relaxed);
  }
  int take() { return next_.fetch_add(1, std::memory_order_relaxed); }
  void finish(int task) { flags_[static_cast<std::size_t>(task)].is_done.store(true, std::memory_order_release); }
  void wait_for(int task) const {
    const std::atomic<bool>& is_done = flags_[static_cast<std::size_t>(task)].is_done;
    for (int tries = 0; !is_done.load(std::memory_order_acquire); ++tries)
      if (tries >= k_tries) std::this_thread::yield();
  }

 private:
  /// Looks before a thread that waits gives its core away.
  static constexpr int k_tries = 1000;
  /// Each on a cache line of its own.
  struct alignas(64) Flag {
    std::atomic<bool> is_done{false};
  };
  std::vector<Flag> flags_;
  std::atomic<int> next_{0};
};

/// The columns of one task, and how to wait for a column of another. Tasks are taken in their order and need only those
/// before them, so that the first unfinished one can always go on.
struct TaskRun {
  std::span<const int> columns;
  const int* task_of;
  int own;
  const TaskProgress* progress;  ///< null where one thread does all tasks

  void wait_for(int column) const {
    if (progress != nullptr && task_of[column] != own) progress->wait_for(task_of[column]);
  }
};

/// Calls body(run) for the tasks of a plan; with one thread once for all of them. Rethrows an exception of a task after
/// all others have run: those that need it take it as done, since they would wait for ever otherwise.
template <class Body>
void run_tasks(const NodePlan& plan, TaskProgress& progress, int threads, const Body& body) {
  if (threads <= 1) {
    body(TaskRun{plan.task_columns, plan.task_of.data(), 0, nullptr});
    return;
  }
  progress.begin();
  LoopException thrown;
  share_work(threads, [&] {
    for (int task = progress.take(); task < plan.num_tasks(); task = progress.take()) {
      const int first = plan.task_start[task], last = plan.task_start[task + 1];
      thrown.guard(body, TaskRun{std::span(plan.task_columns).subspan(first, last - first), plan.task_of.data(), task,
                                 &progress});
      progress.finish(task);
    }
  });
  thrown.rethrow();
}

/// The same in the opposite order, for what needs the columns after each: those above the pieces by one thread first.
template <class Body>
void run_tasks_back(const NodePlan& plan, int threads, const Body& body) {
  const auto columns_of = [&](int first, int last) {
    const int from = plan.task_start[first], to = plan.task_start[last];
    return std::span(plan.task_columns).subspan(from, to - from);
  };
  if (threads <= 1) {
    body(TaskRun{plan.task_columns, plan.task_of.data(), 0, nullptr});
    return;
  }
  body(TaskRun{columns_of(plan.num_pieces, plan.num_tasks()), plan.task_of.data(), 0, nullptr});
  parallel_pieces(plan.num_pieces, threads, [&](std::ptrdiff_t k) {
    body(TaskRun{columns_of(static_cast<int>(k), static_cast<int>(k) + 1), plan.task_of.data(), 0, nullptr});
  });
}

}  // namespace nilas::solvers
