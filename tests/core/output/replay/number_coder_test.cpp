#include "core/output/replay/number_coder.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/output/replay/number_reader.h"

namespace nilas::output::replay {

struct CodedNumber {
  std::size_t kind = 0;
  std::uint8_t past = 0;
  std::int64_t x = 0;
};

/// Numbers of all sizes: mostly small, some as large as positions may be.
static std::vector<CodedNumber> mixed_numbers(std::size_t count, int largest_bits) {
  std::mt19937_64 random(11);
  std::vector<CodedNumber> numbers;
  for (std::size_t k = 0; k < count; ++k) {
    const auto bits = random() % 3 == 0 ? random() % static_cast<std::uint64_t>(largest_bits + 1) : random() % 4;
    const auto size = bits == 0 ? 0 : static_cast<std::int64_t>(random() >> (64 - bits));
    numbers.push_back(
        {random() % k_number_kinds, static_cast<std::uint8_t>(random() % 7), random() % 2 == 0 ? size : -size});
  }
  return numbers;
}

TEST(NumberCoder, NumbersOfAnySizeComeBackOverSeveralFrames) {
  NumberCoder coder;
  test::NumberReader::Shares shares;
  for (int frame = 0; frame < 6; ++frame) {
    if (frame == 4) {
      coder.forget();
      shares.clear();
    }
    const auto numbers = mixed_numbers(20000, 54);
    for (const auto& n : numbers) EXPECT_EQ(coder.add(n.kind, n.past, n.x), test::digits_of(n.x));
    test::NumberReader reader(coder.finish(), shares);
    for (const auto& n : numbers) ASSERT_EQ(reader.number(static_cast<int>(n.kind), n.past), n.x);
    EXPECT_TRUE(reader.at_end());
  }
  test::NumberReader reader(coder.finish(), shares);
  EXPECT_TRUE(reader.at_end()) << "a frame without a number";
}

/// Zeros that come after zeros take next to nothing, and even digits what they must.
TEST(NumberCoder, NumbersTakeAsManyBitsAsTheyAreUnlikely) {
  NumberCoder coder;
  for (int k = 0; k < 10000; ++k) coder.add(k_of_position, 0, 0);
  EXPECT_LT(coder.finish().size(), 30u);
  std::mt19937 random(3);
  for (int k = 0; k < 10000; ++k) coder.add(k_of_turn, 0, static_cast<std::int64_t>(random() % 256) - 128);
  EXPECT_LT(static_cast<double>(coder.finish().size()), 1.05 * 10000);
}

/// Digits that are nearly certain to be 0 and are 1 hold the code just below a whole byte, so that carries run far.
TEST(NumberCoder, CarriesRunThroughBytesThatWait) {
  for (int first = 1; first < 400; ++first) {
    NumberCoder coder;
    test::NumberReader::Shares shares;
    for (int k = 0; k < first; ++k) coder.add(k_of_speed, 1, k % 2 == 0 ? 1 : -1);
    for (int k = 0; k < 40; ++k) coder.add(k_of_speed, 1, -(std::int64_t{1} << 50) + 1);
    test::NumberReader reader(coder.finish(), shares);
    for (int k = 0; k < first; ++k) ASSERT_EQ(reader.number(k_of_speed, 1), k % 2 == 0 ? 1 : -1);
    for (int k = 0; k < 40; ++k) ASSERT_EQ(reader.number(k_of_speed, 1), -(std::int64_t{1} << 50) + 1);
  }
}

}  // namespace nilas::output::replay
