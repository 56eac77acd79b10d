#include "core/base/json_text.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace nilas {
namespace json_text_test {

TEST(JsonText, ADepthOfAHundredIsTheLimit) {
  EXPECT_FALSE(is_nested_deeply(std::string(100, '[')));
  EXPECT_TRUE(is_nested_deeply(std::string(101, '[')));
  std::string side_by_side;
  for (int k = 0; k < 1000; ++k) side_by_side += "[{}],";
  EXPECT_FALSE(is_nested_deeply(side_by_side));
}

TEST(JsonText, BracketsInTextsDoNotCount) {
  const std::string brackets(1000, '[');
  EXPECT_FALSE(is_nested_deeply("\"" + brackets + "\""));
  EXPECT_FALSE(is_nested_deeply("\"\\\"" + brackets + "\"")) << "a quote within the text";
  EXPECT_TRUE(is_nested_deeply("\"\\\\\"" + brackets)) << "the text has ended";
}

TEST(JsonText, AFileIsReadOrRefused) {
  const test::ScratchFolder folder;
  EXPECT_EQ(json_file_text(folder.write("a.json", "{}")), "{}");
  test::expect_refusal([&] { json_file_text(folder.write("b.json", std::string(100000, '{'))); }, {"b.json", "nested"});
  EXPECT_THROW(json_file_text(folder / "absent"), FileError);
}

}  // namespace json_text_test
}  // namespace nilas
