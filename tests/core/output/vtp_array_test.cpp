#include "core/output/vtp_array.h"

#include <gtest/gtest.h>

#include <random>

namespace nilas {
namespace {

/// Decodes an LZ4 block by the format's rules, and checks the rules for its end.
std::string decompress(const std::string& block) {
  std::string out;
  std::size_t at = 0, last_match_start = 0;
  const auto byte = [&] { return static_cast<std::size_t>(static_cast<unsigned char>(block.at(at++))); };
  const auto length = [&](std::size_t nibble) {
    if (nibble < 15) return nibble;
    for (std::size_t more = 255; more == 255;) nibble += more = byte();
    return nibble;
  };
  bool matched = false;
  while (true) {
    const std::size_t token = byte(), literals = length(token >> 4);
    out += block.substr(at, literals);
    at += literals;
    if (at == block.size()) {
      if (matched) {
        EXPECT_GE(literals, 5u);
        EXPECT_GE(out.size() - last_match_start, 12u);
      }
      return out;
    }
    const std::size_t low = byte(), distance = low + (byte() << 8), match = length(token & 15) + 4;
    EXPECT_LE(distance, out.size());
    last_match_start = out.size();
    for (std::size_t k = 0; k < match; ++k) out += out[out.size() - distance];
    matched = true;
  }
}

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& x) {
  return std::as_bytes(std::span(x));
}

template <class T>
std::string text_of(const std::vector<T>& x) {
  return {reinterpret_cast<const char*>(x.data()), x.size() * sizeof(T)};
}

TEST(CompressRepeats, ComesBackForAnyRuns) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<std::int32_t> x;
    for (auto run = random() % 6; run-- > 0;)
      x.insert(x.end(), random() % (trial % 7 == 0 ? 400 : 9), static_cast<std::int32_t>(random() % 3));
    const std::vector<std::uint8_t> small(x.begin(), x.end());
    EXPECT_EQ(decompress(compress_repeats(bytes_of(x), 4)), text_of(x));
    EXPECT_EQ(decompress(compress_repeats(bytes_of(x), 12)), text_of(x));
    EXPECT_EQ(decompress(compress_repeats(bytes_of(small), 1)), text_of(small));
  }
}

TEST(CompressRepeats, RepeatsCostNextToNothingAndNoiseNextToNothingMore) {
  const std::vector<double> repeats(10000, 3.25);
  EXPECT_LT(compress_repeats(bytes_of(repeats), 8).size(), 80000u / 200);
  std::mt19937 random(1);
  std::vector<std::uint32_t> noise(10000);
  for (auto& x : noise) x = static_cast<std::uint32_t>(random());
  EXPECT_LT(compress_repeats(bytes_of(noise), 4).size(), 40000u * 101 / 100);
}

TEST(DataArray, IsAnElementWithHeaderAndBlockInBase64) {
  std::string text = "before ";
  add_data_array({"id", "UInt8", 1}, std::vector<std::uint8_t>{1, 2, 3}, text);
  // header 1 3 0 4 as four 32-bit words; block: token of 3 literals, then 1 2 3
  EXPECT_EQ(text,
            "before <DataArray type=\"UInt8\" Name=\"id\" NumberOfComponents=\"1\" format=\"binary\">"
            "AQAAAAMAAAAAAAAABAAAAA==MAECAw==</DataArray>\n");
}

}  // namespace
}  // namespace nilas
