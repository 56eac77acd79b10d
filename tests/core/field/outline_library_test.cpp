#include "core/field/outline_library.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/field/field.h"
#include "tests/support/mentions.h"
#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace nilas::field {
namespace outline_library_test {

class OutlineLibrary : public testing::Test {
 protected:
  std::vector<std::vector<Vec2>> read(const std::string& text) const {
    return read_outlines(folder_.write("floes.json", text));
  }
  std::string refusal(const std::string& text) const {
    return test::refusal([&] { read(text); });
  }
  test::ScratchFolder folder_;
};

const std::vector<Vec2> k_triangle{{0, 0}, {2, 0}, {0, 1}};

TEST_F(OutlineLibrary, TakesFlatListsPairsBodiesAndGeoJson) {
  for (const char* text :
       {"[[0,0,2,0,0,1]]", "[[[0,0],[2,0],[0,1]]]", "[[[0,0],[2,0],[0,1],[0,0]]]", R"({"bodies": [[0,0,2,0,0,1]]})",
        R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": null, "geometry":
            {"type": "Polygon", "coordinates": [[[0,0],[2,0],[0,1],[0,0]]]}}]})"}) {
    SCOPED_TRACE(text);
    const auto outlines = read(text);
    ASSERT_EQ(outlines.size(), 1u);
    EXPECT_EQ(outlines[0], k_triangle);
  }
}

TEST_F(OutlineLibrary, TurnsClockwiseOutlines) { EXPECT_EQ(read("[[0,1,2,0,0,0]]")[0], k_triangle); }

TEST_F(OutlineLibrary, NamesTheOutlineAtFault) {
  EXPECT_PRED2(test::mentions, refusal("[[0,0,2,0,0,1],[0,0,1]]"), "outline 2: found 3 numbers");
  EXPECT_PRED2(test::mentions, refusal("[[0,0,2,2,2,0,0,2]]"), "outline 1: the outline crosses");
  EXPECT_PRED2(test::mentions, refusal("[[0,0,1,1]]"), "outline 1: found 2 corners");
  EXPECT_PRED2(test::mentions, refusal("[[[0,0,0],[1,0],[0,1]]]"), "allowed [x, y]");
  EXPECT_PRED2(test::mentions, refusal("[]"), "expected a list");
  EXPECT_PRED2(test::mentions, refusal("{"), "not JSON");
  EXPECT_THROW(read_outlines(folder_.path() / "none.json"), FileError);
}

}  // namespace outline_library_test
}  // namespace nilas::field
