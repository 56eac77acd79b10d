/// Elements of HTML pages.
#include "core/output/text/html.h"

#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace html_test {

using namespace nilas;
using namespace nilas::output;

TEST(Html, LeavesNoMarkupInText) { EXPECT_EQ(html_text("<a href='b'>\"&"), "&lt;a href=&#39;b&#39;&gt;&quot;&amp;"); }

TEST(Html, TakesThePictureAloneOutOfItsFile) {
  const test::ScratchFolder folder;
  const auto file = folder.write("a.svg", "<?xml version=\"1.0\"?>\n<!DOCTYPE svg>\n<svg width=\"2\"></svg>\n");
  EXPECT_EQ(inline_svg(file), "<svg width=\"2\"></svg>\n");
}

TEST(Html, RefusesAFileWithoutAPicture) {
  const test::ScratchFolder folder;
  const auto file = folder.write("cut.svg", "<?xml version=\"1.0\"?>\n");
  test::expect_refusal<FileError>([&] { inline_svg(file); }, {file.string() + " holds no picture"});
  test::expect_refusal<FileError>([&] { inline_svg(folder / "absent.svg"); }, {"there is no such file"});
}

}  // namespace html_test
