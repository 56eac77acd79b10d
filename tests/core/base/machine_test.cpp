#include "core/base/machine.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace nilas {
namespace machine_test {

using Clock = std::chrono::steady_clock;

/// A thread that computes takes processor time, and one that waits takes next to none. A busy machine only makes the
/// loop last longer.
TEST(ProcessorSeconds, CountsWorkAndNotWaiting) {
  const double start = processor_seconds();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const double waited = processor_seconds() - start;
  EXPECT_GE(waited, 0);
  EXPECT_LT(waited, 0.05);
  std::thread([&] {
    const auto late = Clock::now() + std::chrono::seconds(20);
    while (processor_seconds() - start - waited < 0.1 && Clock::now() < late) {
    }
  }).join();
  EXPECT_GE(processor_seconds() - start - waited, 0.1) << "of another thread";
}

}  // namespace machine_test
}  // namespace nilas
