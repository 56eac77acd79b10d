/// Damaged scenes are read or refused, with a place, never anything else.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/scene/complete_scene.h"

namespace nilas::scene {
namespace fuzz_test {

using testing::SceneFolder;

/// Small linear congruential generator; the same damage on every machine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  std::size_t roll(std::size_t sides) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>(state_ >> 33U) % sides;
  }

 private:
  std::uint64_t state_;
};

/// Start and length of every attribute value of the scene below the root's own.
std::vector<std::pair<std::size_t, std::size_t>> values_in(const std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> values;
  for (auto open = text.find("=\"", text.find("<time")); open != std::string::npos; open = text.find("=\"", open)) {
    const auto close = text.find('"', open + 2);
    values.emplace_back(open + 2, close - open - 2);
    open = close;
  }
  return values;
}

bool all_finite(const Scene& scene) {
  bool finite = scene.gravity.allFinite() && std::isfinite(scene.time.step) && std::isfinite(scene.time.end);
  for (const auto& body : scene.bodies)
    finite = finite && body.position.allFinite() && std::isfinite(body.mass.value_or(0));
  return finite;
}

TEST(Fuzz, StrangeValuesInEveryAttribute) {
  const SceneFolder folder;
  testing::write_inputs(folder);
  const std::string whole = testing::k_complete_scene;
  for (const auto& [start, length] : values_in(whole)) {
    for (const char* strange : {"nan", "inf", "-1e999", "1e308", "-1", "0", "", " ", "1 2 3 4 5 6 7 8", "0x1p3",
                                "1e-320", "99999999999999999999", "-0", "true", "&#0;", "&amp;", "../..", "ice\tice"}) {
      std::string text = whole;
      text.replace(start, length, strange);
      try {
        EXPECT_TRUE(all_finite(folder.read(text))) << text.substr(start - 20, 40);
      } catch (const SceneError& error) {
        for (const auto& fault : error.faults()) EXPECT_GT(fault.line, 0) << fault.text();
      }
    }
  }
}

TEST(Fuzz, DamagedBytes) {
  const SceneFolder folder;
  testing::write_inputs(folder);
  const std::string whole = testing::k_complete_scene;
  const std::string bytes = "<>/\"'=&; \n\t!-?[]0x\xff\x01";
  Dice dice(2);
  int read = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    std::string text = whole;
    for (std::size_t hit = dice.roll(3) + 1; hit > 0; --hit)
      text[dice.roll(text.size())] = bytes[dice.roll(bytes.size())];
    try {
      folder.read(text);
      ++read;
    } catch (const SceneError& error) {
      for (const auto& fault : error.faults()) EXPECT_GT(fault.line, 0) << fault.text();
    }
  }
  EXPECT_GT(read, 0) << "damage in comments and blanks does no harm";
}

}  // namespace fuzz_test
}  // namespace nilas::scene
