#include "core/field/outline_library.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "core/field/field.h"
#include "tests/support/scratch_folder.h"

namespace nilas {
namespace {

class OutlineLibrary : public testing::Test {
 protected:
  std::vector<std::vector<Vec2>> read(const std::string& text) const {
    const auto file = folder_.path() / "floes.json";
    std::ofstream(file) << text;
    return read_outlines(file);
  }
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
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
  const auto names = [](const std::string& text, const std::string& part) { return text.find(part) != text.npos; };
  EXPECT_PRED2(names, refusal("[[0,0,2,0,0,1],[0,0,1]]"), "outline 2: found 3 numbers");
  EXPECT_PRED2(names, refusal("[[0,0,2,2,2,0,0,2]]"), "outline 1: the outline crosses");
  EXPECT_PRED2(names, refusal("[[0,0,1,1]]"), "outline 1: found 2 corners");
  EXPECT_PRED2(names, refusal("[[[0,0,0],[1,0],[0,1]]]"), "allowed [x, y]");
  EXPECT_PRED2(names, refusal("[]"), "expected a list");
  EXPECT_PRED2(names, refusal("{"), "not JSON");
  EXPECT_THROW(read_outlines(folder_.path() / "none.json"), FileError);
}

}  // namespace
}  // namespace nilas
