#include "core/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/base/machine.h"

namespace nilas {
namespace parallel_test {

TEST(ParallelFor, EveryItemOnceAndTheSameBitsForAnyThreadCount) {
  const auto run = [](int threads) {
    std::vector<double> result(1001, 0);
    parallel_for(static_cast<std::ptrdiff_t>(result.size()), threads,
                 [&](std::ptrdiff_t i) { result[i] += std::sin(0.1 * static_cast<double>(i)) + 2; });
    return result;
  };
  const auto one = run(1);
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i], std::sin(0.1 * static_cast<double>(i)) + 2);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(run(threads), one);
}

TEST(ParallelPieces, EveryPieceOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    std::vector<int> calls(37, 0);
    parallel_pieces(static_cast<std::ptrdiff_t>(calls.size()), threads, [&](std::ptrdiff_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(37, 1));
  }
}

TEST(ParallelFor, NothingToDo) {
  int calls = 0;
  parallel_for(0, 2, [&](std::ptrdiff_t) { ++calls; });
  EXPECT_EQ(calls, 0);
}

TEST(ParallelFor, WhatAnItemThrowsReachesTheCaller) {
  for (const int threads : {1, 2, 3}) {
    std::vector<int> calls(100, 0);
    const auto run = [&] {
      parallel_for(static_cast<std::ptrdiff_t>(calls.size()), threads, [&](std::ptrdiff_t i) {
        ++calls[i];
        if (i % 40 == 7) throw std::runtime_error("no item");
      });
    };
    EXPECT_THROW(run(), std::runtime_error);
    EXPECT_EQ(calls, std::vector<int>(100, 1)) << "the others run all the same";
  }
}

/// The first item waits for the second, which only another thread can do meanwhile.
TEST(ParallelPieces, TwoThreadsWorkAtTheSameTime) {
  std::atomic<bool> is_second_done = false;
  std::thread::id first, second;
  parallel_pieces(2, 2, [&](std::ptrdiff_t i) {
    (i == 0 ? first : second) = std::this_thread::get_id();
    if (i == 1) is_second_done = true;
    while (!is_second_done) std::this_thread::yield();
  });
  EXPECT_NE(first, second);
}

/// A loop within a loop goes on its thread alone: the helpers have their work already.
TEST(ParallelPieces, WithinPieces) {
  std::vector<int> calls(5 * 7, 0);
  parallel_pieces(5, 3, [&](std::ptrdiff_t i) {
    const std::thread::id outer = std::this_thread::get_id();
    parallel_pieces(7, 3, [&](std::ptrdiff_t k) {
      ++calls[7 * i + k];
      EXPECT_EQ(std::this_thread::get_id(), outer);
    });
  });
  EXPECT_EQ(calls, std::vector<int>(5 * 7, 1));
}

/// Two threads of a program that both ask for help, as two simulations do.
TEST(ParallelFor, LoopsOfTwoThreadsAtOnce) {
  const auto run = [](std::vector<int>& calls) {
    for (int again = 0; again < 500; ++again)
      parallel_for(static_cast<std::ptrdiff_t>(calls.size()), 2, [&](std::ptrdiff_t i) { ++calls[i]; });
  };
  std::vector<int> here(50, 0), there(50, 0);
  std::thread other([&] { run(there); });
  run(here);
  other.join();
  EXPECT_EQ(here, std::vector<int>(50, 500));
  EXPECT_EQ(there, here);
}

/// A helper that looked for work all the time would take 5 ms of its core in each pause. It may look for some
/// microseconds, and waking it takes some more.
TEST(ParallelPieces, HelpersSleepBetweenLoops) {
  constexpr int k_loops = 40;
  constexpr double k_per_loop = 5e-4;  // [s]
  std::vector<int> values(4, 0);
  const double before = processor_seconds();
  for (int loop = 0; loop < k_loops; ++loop) {
    parallel_pieces(4, 2, [&](std::ptrdiff_t i) { ++values[i]; });
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_LT(processor_seconds() - before, k_loops * k_per_loop);
  EXPECT_EQ(values, std::vector<int>(4, k_loops));
}

}  // namespace parallel_test
}  // namespace nilas
