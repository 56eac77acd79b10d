#include "core/output/vtk/vtp_array.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/error.h"

namespace nilas::output {
namespace vtp_array_test {

/// Whether a block keeps the format's rules for its end, which decoders of other makes rely on.
void expect_a_lawful_end(const std::string& block) {
  std::size_t at = 0, plain = 0, last_match_start = 0;
  const auto byte = [&] { return static_cast<std::size_t>(static_cast<unsigned char>(block.at(at++))); };
  const auto length = [&](std::size_t nibble) {
    if (nibble < 15) return nibble;
    for (std::size_t more = 255; more == 255;) nibble += more = byte();
    return nibble;
  };
  bool matched = false;
  while (true) {
    const std::size_t token = byte(), literals = length(token >> 4);
    plain += literals;
    at += literals;
    if (at == block.size()) {
      if (matched) {
        EXPECT_GE(literals, 5u);
        EXPECT_GE(plain - last_match_start, 12u);
      }
      return;
    }
    at += 2;  // the distance
    last_match_start = plain;
    plain += length(token & 15) + 4;
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
    const auto comes_back = [](const std::string& block, const std::string& plain) {
      expect_a_lawful_end(block);
      EXPECT_EQ(expand_block(block, plain.size()), plain);
    };
    comes_back(compress_repeats(bytes_of(x), 4), text_of(x));
    comes_back(compress_repeats(bytes_of(x), 12), text_of(x));
    comes_back(compress_repeats(bytes_of(small), 1), text_of(small));
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

TEST(ExpandBlock, RefusesWhatIsNoBlock) {
  const std::string block = compress_repeats(bytes_of(std::vector<double>(100, 3.25)), 8);
  EXPECT_EQ(expand_block(block, 800).size(), 800u);
  EXPECT_THROW(expand_block(block, 799), InputError);
  EXPECT_THROW(expand_block(block, 801), InputError);
  for (std::size_t k = 0; k < block.size(); ++k) EXPECT_THROW(expand_block(block.substr(0, k), 800), InputError) << k;
  EXPECT_THROW(expand_block(std::string("\x10"
                                        "a\x05\0",
                                        4),
                            6),
               InputError)
      << "a match from before the beginning";
}

/// The text between the tags of an element.
std::string inner(const std::string& element) {
  const std::size_t begin = element.find('>') + 1;
  return element.substr(begin, element.rfind('<') - begin);
}

TEST(DataArray, ComesBackFromItsText) {
  for (const std::size_t count : {0u, 1u, 2u, 3u, 1000u}) {
    std::vector<double> x(count);
    for (std::size_t k = 0; k < count; ++k) x[k] = 1.0 / (1.0 + static_cast<double>(k / 3));
    std::string text;
    add_data_array({"x", "Float64", 1}, x, text);
    EXPECT_EQ(array_bytes(inner(text)), text_of(x)) << count;
  }
  EXPECT_THROW(array_bytes("no base64!!!"), InputError);
  EXPECT_THROW(array_bytes("AAAA"), InputError);
}

TEST(DataArray, FieldDataSayHowManyAndTextsEndWithAZero) {
  std::string text;
  add_data_array({"body_id", "Int64", 1, true}, std::vector<std::int64_t>{4, 5}, text);
  EXPECT_NE(text.find("NumberOfTuples=\"2\""), std::string::npos);
  text.clear();
  add_text_array("body_name", {"pier", "a<b"}, text);
  EXPECT_EQ(text.substr(0, text.find('>')),
            "<Array type=\"String\" Name=\"body_name\" NumberOfTuples=\"2\" format=\"binary\"");
  EXPECT_EQ(array_bytes(inner(text)), std::string("pier\0a<b\0", 9));
}

TEST(DataArray, IsAnElementWithHeaderAndBlockInBase64) {
  std::string text = "before ";
  add_data_array({"id", "UInt8", 1}, std::vector<std::uint8_t>{1, 2, 3}, text);
  // header 1 3 0 4 as four 32-bit words; block: token of 3 literals, then 1 2 3
  EXPECT_EQ(text,
            "before <DataArray type=\"UInt8\" Name=\"id\" NumberOfComponents=\"1\" format=\"binary\">"
            "AQAAAAMAAAAAAAAABAAAAA==MAECAw==</DataArray>\n");
}

}  // namespace vtp_array_test
}  // namespace nilas::output
