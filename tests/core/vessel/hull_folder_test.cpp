#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "core/vessel/hull.h"

namespace nilas {
namespace {

namespace fs = std::filesystem;

class HullFolder : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / ("nilas_hull_" + std::string(test->name()) + "_" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static Hull example() { return generate_hull(hull_form("icebreaker", {{"triangles", 1000}})); }
  static std::string refusal(const fs::path& path) {
    try {
      read_hull(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  fs::path folder_;
};

bool names(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Corners of every triangle in order: what an STL file holds.
std::vector<Vec3> corners(const TriangleMesh& mesh) {
  std::vector<Vec3> all;
  for (const auto& t : mesh.triangles)
    for (const int v : t) all.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
  return all;
}

/// Two boxes side by side in an L: closed and outward, not convex.
TriangleMesh l_shape() {
  const std::vector<Vec2> outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  return prism_shape(outline, 1).surface;
}

TEST_F(HullFolder, RoundTripKeepsEveryBit) {
  const Hull hull = example();
  write_hull(hull, folder_ / "ship", "{\"parts\": 1}\n");
  const Hull read = read_hull(folder_ / "ship");
  EXPECT_EQ(corners(read.fluid), corners(hull.fluid));
  ASSERT_EQ(read.parts.size(), hull.parts.size());
  EXPECT_EQ(corners(read.parts[0]), corners(hull.parts[0]));
  EXPECT_EQ(read.fluid.vertices.size(), hull.fluid.vertices.size());
}

TEST_F(HullFolder, WritingAgainLeavesNoPartOfTheHullBefore) {
  Hull hull = example();
  hull.parts.push_back(hull.parts[0]);
  write_hull(hull, folder_, "{}");
  hull.parts.pop_back();
  write_hull(hull, folder_, "{}");
  EXPECT_EQ(read_hull(folder_).parts.size(), 1u);
}

TEST_F(HullFolder, ConvexStlIsItsOwnPart) {
  const Hull hull = example();
  write_stl(hull.fluid, folder_ / "ship.stl");
  const Hull read = read_hull(folder_ / "ship.stl");
  ASSERT_EQ(read.parts.size(), 1u);
  EXPECT_EQ(corners(read.parts[0]), corners(hull.fluid));
}

TEST_F(HullFolder, ConcaveStlAsksForAFolderWithConvexParts) {
  write_stl(l_shape(), folder_ / "l.stl");
  const std::string text = refusal(folder_ / "l.stl");
  EXPECT_PRED2(names, text, "l.stl");
  EXPECT_PRED2(names, text, "not convex");
  EXPECT_PRED2(names, text, "nilas hull");
  EXPECT_PRED2(names, text, "folder with convex parts");
}

TEST_F(HullFolder, ConcaveSurfaceWithConvexPartsIsRead) {
  const auto box = [](double x0, double y0, double x1, double y1) {
    TriangleMesh mesh = prism_shape({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, 1).surface;
    return mesh;
  };
  write_hull({l_shape(), {box(0, 0, 2, 1), box(0, 1, 1, 2)}}, folder_, "{\"parts\": 2}");
  EXPECT_EQ(read_hull(folder_).parts.size(), 2u);
  write_hull({l_shape(), {l_shape()}}, folder_, "{\"parts\": 1}");
  EXPECT_PRED2(names, refusal(folder_), "part-01.stl: the surface is not convex");
}

TEST_F(HullFolder, UnsoundMeshesAreNamedWithTheirDefects) {
  Hull open = example();
  open.fluid.triangles.pop_back();
  write_hull(open, folder_, "{}");
  EXPECT_PRED2(names, refusal(folder_), "fluid.stl");
  EXPECT_PRED2(names, refusal(folder_), "3 open edges");

  Hull inward = example();
  for (auto& t : inward.parts[0].triangles) std::swap(t[1], t[2]);
  write_hull(inward, folder_, "{}");
  EXPECT_PRED2(names, refusal(folder_), "part-01.stl");
  EXPECT_PRED2(names, refusal(folder_), "inwards");

  Hull needle = example();
  auto& [a, b, c] = needle.fluid.triangles.front();
  const int corner = static_cast<int>(needle.fluid.vertices.size());
  const Vec3 middle =
      0.5 * (needle.fluid.vertices[static_cast<std::size_t>(a)] + needle.fluid.vertices[static_cast<std::size_t>(b)]);
  needle.fluid.vertices.push_back(middle);
  needle.fluid.triangles.push_back({a, corner, b});
  needle.fluid.triangles.push_back({a, b, corner});
  write_hull(needle, folder_, "{}");
  EXPECT_NE(refusal(folder_), "accepted");
}

TEST_F(HullFolder, DescriptionMustAgreeWithTheParts) {
  write_hull(example(), folder_, "{\"parts\": 3}");
  EXPECT_PRED2(names, refusal(folder_), "hull.json");
  EXPECT_PRED2(names, refusal(folder_), "3");
  write_hull(example(), folder_, "{\"parts\": ");
  EXPECT_PRED2(names, refusal(folder_), "hull.json");
  write_hull(example(), folder_, "{}");
  EXPECT_EQ(refusal(folder_), "accepted");
  fs::remove(folder_ / "hull.json");
  EXPECT_EQ(refusal(folder_), "accepted");
}

TEST_F(HullFolder, MissingFilesAreFileErrors) {
  EXPECT_THROW(read_hull(folder_ / "none"), FileError);
  EXPECT_THROW(read_hull(folder_ / "none.stl"), FileError);
  EXPECT_THROW(read_hull(folder_), FileError);  // a folder without fluid.stl
  write_stl(example().fluid, folder_ / "fluid.stl");
  EXPECT_PRED2(names, refusal(folder_), "part-NN.stl");
  std::ofstream(folder_ / "file") << "x";
  EXPECT_THROW(write_hull(example(), folder_ / "file" / "ship", "{}"), FileError);
}

}  // namespace
}  // namespace nilas
