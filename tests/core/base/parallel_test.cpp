#include "core/base/parallel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

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

}  // namespace parallel_test
}  // namespace nilas
