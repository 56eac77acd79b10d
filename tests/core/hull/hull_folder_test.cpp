#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "core/hull/hull.h"
#include "core/hull/hull_parts.h"
#include "core/hull/new_hull_folder.h"
#include "tests/support/mentions.h"
#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace nilas::hull {
namespace hull_folder_test {

namespace fs = std::filesystem;

class HullFolder : public testing::Test {
 protected:
  static void replace(const fs::path& folder, const Hull& hull, const std::string& json) {
    NewHullFolder made(folder, true);
    write_hull(hull, made.staging(), json);
    made.publish();
  }
  static Hull example() { return generate_hull(hull_form("icebreaker", {{"triangles", 1000}})); }
  static std::string refusal(const fs::path& path) {
    return test::refusal([&] { read_hull(path); });
  }

  const test::ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
};

/// Corners of every triangle in order, which is the content of an STL file.
std::vector<Vec3> corners(const geometry::TriangleMesh& mesh) {
  std::vector<Vec3> all;
  for (const auto& t : mesh.triangles)
    for (const int v : t) all.push_back(mesh.vertices[v]);
  return all;
}

/// Two boxes side by side in an L: closed and outward, not convex.
geometry::TriangleMesh l_shape() {
  const std::vector<Vec2> outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  return geometry::prism_shape(outline, 1).surface;
}

TEST_F(HullFolder, RoundTripKeepsEveryBit) {
  const Hull hull = example();
  replace(folder_ / "ship", hull, "{\"parts\": 1}\n");
  const Hull read = read_hull(folder_ / "ship");
  EXPECT_EQ(corners(read.fluid), corners(hull.fluid));
  ASSERT_EQ(read.parts.size(), hull.parts.size());
  EXPECT_EQ(corners(read.parts[0]), corners(hull.parts[0]));
  EXPECT_EQ(read.fluid.vertices.size(), hull.fluid.vertices.size());
}

TEST_F(HullFolder, WritingAgainLeavesNoPartOfTheHullBefore) {
  Hull hull = example();
  hull.parts.push_back(hull.parts[0]);
  replace(folder_, hull, "{}");
  hull.parts.pop_back();
  replace(folder_, hull, "{}");
  EXPECT_EQ(read_hull(folder_).parts.size(), 1u);
}

TEST_F(HullFolder, PartsAreOrderedByTheirNumber) {
  const geometry::TriangleMesh box = geometry::prism_shape({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1).surface;
  Hull hull{box, {}};
  for (int k = 0; k < 101; ++k) {
    hull.parts.push_back(box);
    for (auto& p : hull.parts.back().vertices) p.x() += k;
  }
  write_hull(hull, folder_, "{}");
  const Hull read = read_hull(folder_);
  ASSERT_EQ(read.parts.size(), hull.parts.size());
  for (std::size_t k = 0; k < hull.parts.size(); ++k) EXPECT_EQ(corners(read.parts[k]), corners(hull.parts[k])) << k;
  for (std::size_t k = 1; k < 1000; ++k) EXPECT_LT(part_name(k), part_name(k + 1)) << "listed by name";
  // folders of two digits and more
  for (std::size_t k = 1; k <= hull.parts.size(); ++k)
    fs::rename(folder_ / part_name(k),
               folder_ / ("part-" + std::string(k < 10 ? "0" : "") + std::to_string(k) + ".stl"));
  const Hull earlier = read_hull(folder_);
  ASSERT_EQ(earlier.parts.size(), hull.parts.size());
  for (std::size_t k = 0; k < hull.parts.size(); ++k) EXPECT_EQ(corners(earlier.parts[k]), corners(hull.parts[k])) << k;
}

TEST_F(HullFolder, WhatIsNotTheHullsStaysAndForceIsNeeded) {
  std::ofstream(folder_ / "notes.txt") << "mine";
  EXPECT_THROW(NewHullFolder(folder_, false), InputError);
  replace(folder_, example(), "{}");
  EXPECT_THROW(NewHullFolder(folder_, false), InputError);
  replace(folder_, example(), "{}");
  EXPECT_TRUE(fs::exists(folder_ / "notes.txt"));
  std::ofstream(folder_ / "part-bow.stl") << "mine";
  EXPECT_PRED2(test::mentions, refusal(folder_), "part-bow.stl");
  EXPECT_THROW(NewHullFolder(folder_, true), InputError);
  EXPECT_TRUE(fs::exists(folder_ / "part-bow.stl"));
}

TEST_F(HullFolder, AHullThatIsNotPublishedLeavesTheOldOneWhole) {
  replace(folder_, example(), "{\"parts\": 1}");
  Hull two = example();
  two.parts.push_back(two.parts[0]);
  {
    NewHullFolder made(folder_, true);
    write_hull(two, made.staging(), "{\"parts\": 2}");
    EXPECT_EQ(read_hull(folder_).parts.size(), 1u);
  }
  EXPECT_EQ(read_hull(folder_).parts.size(), 1u);
  EXPECT_FALSE(fs::exists(folder_ / ".hull.part"));
  { const NewHullFolder for_nothing(folder_ / "ship", false); }
  EXPECT_FALSE(fs::exists(folder_ / "ship"));
}

TEST_F(HullFolder, ARefusedMeshAndAHullNeverShareTheFolder) {
  replace(folder_, example(), "{\"parts\": 1}");
  {
    NewHullFolder refused(folder_, true);
    std::ofstream(refused.staging() / "faults.png") << "x";
    refused.publish();
  }
  EXPECT_FALSE(fs::exists(folder_ / "hull.json"));
  EXPECT_THROW(read_hull(folder_), FileError);
  NewHullFolder made(folder_, false);  // The picture of a refused mesh must not be kept.
  write_hull(example(), made.staging(), "{\"parts\": 1}");
  made.publish();
  EXPECT_FALSE(fs::exists(folder_ / "faults.png"));
  EXPECT_EQ(read_hull(folder_).parts.size(), 1u);
}

TEST_F(HullFolder, ConvexStlIsItsOwnPart) {
  const Hull hull = example();
  geometry::write_stl(hull.fluid, folder_ / "ship.stl");
  const Hull read = read_hull(folder_ / "ship.stl");
  ASSERT_EQ(read.parts.size(), 1u);
  EXPECT_EQ(corners(read.parts[0]), corners(hull.fluid));
}

TEST_F(HullFolder, ConcaveStlAsksForAFolderWithConvexParts) {
  geometry::write_stl(l_shape(), folder_ / "l.stl");
  const std::string text = refusal(folder_ / "l.stl");
  EXPECT_PRED2(test::mentions, text, "l.stl");
  EXPECT_PRED2(test::mentions, text, "not convex");
  EXPECT_PRED2(test::mentions, text, "nilas hull");
  EXPECT_PRED2(test::mentions, text, "folder with convex parts");
}

TEST_F(HullFolder, ConcaveSurfaceWithConvexPartsIsRead) {
  const auto box = [](double x0, double y0, double x1, double y1) {
    geometry::TriangleMesh mesh = geometry::prism_shape({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, 1).surface;
    return mesh;
  };
  replace(folder_, {l_shape(), {box(0, 0, 2, 1), box(0, 1, 1, 2)}}, "{\"parts\": 2}");
  EXPECT_EQ(read_hull(folder_).parts.size(), 2u);
  replace(folder_, {l_shape(), {l_shape()}}, "{\"parts\": 1}");
  EXPECT_PRED2(test::mentions, refusal(folder_), "part-0001.stl: the surface is not convex");
}

TEST_F(HullFolder, UnsoundMeshesAreNamedWithTheirDefects) {
  Hull open = example();
  open.fluid.triangles.pop_back();
  replace(folder_, open, "{}");
  EXPECT_PRED2(test::mentions, refusal(folder_), "fluid.stl");
  EXPECT_PRED2(test::mentions, refusal(folder_), "3 open edges");

  Hull inward = example();
  for (auto& t : inward.parts[0].triangles) std::swap(t[1], t[2]);
  replace(folder_, inward, "{}");
  EXPECT_PRED2(test::mentions, refusal(folder_), "part-0001.stl");
  EXPECT_PRED2(test::mentions, refusal(folder_), "inwards");

  Hull needle = example();
  auto& [a, b, c] = needle.fluid.triangles.front();
  const int corner = static_cast<int>(needle.fluid.vertices.size());
  const Vec3 middle = 0.5 * (needle.fluid.vertices[a] + needle.fluid.vertices[b]);
  needle.fluid.vertices.push_back(middle);
  needle.fluid.triangles.push_back({a, corner, b});
  needle.fluid.triangles.push_back({a, b, corner});
  replace(folder_, needle, "{}");
  EXPECT_NE(refusal(folder_), "accepted");
}

TEST_F(HullFolder, DescriptionMustAgreeWithTheParts) {
  replace(folder_, example(), "{\"parts\": 3}");
  EXPECT_PRED2(test::mentions, refusal(folder_), "hull.json");
  EXPECT_PRED2(test::mentions, refusal(folder_), "3");
  replace(folder_, example(), "{\"parts\": ");
  EXPECT_PRED2(test::mentions, refusal(folder_), "hull.json");
  replace(folder_, example(), "{}");
  EXPECT_EQ(refusal(folder_), "accepted");
  fs::remove(folder_ / "hull.json");
  EXPECT_EQ(refusal(folder_), "accepted");
}

TEST_F(HullFolder, MissingFilesAreFileErrors) {
  EXPECT_THROW(read_hull(folder_ / "none"), FileError);
  EXPECT_THROW(read_hull(folder_ / "none.stl"), FileError);
  EXPECT_THROW(read_hull(folder_ / std::string(300, 'x')), FileError);
  fs::create_symlink("loop", folder_ / "loop");
  EXPECT_THROW(read_hull(folder_ / "loop"), FileError);
  EXPECT_THROW(read_hull(folder_), FileError);  // a folder without fluid.stl
  geometry::write_stl(example().fluid, folder_ / "fluid.stl");
  EXPECT_PRED2(test::mentions, refusal(folder_), "part-NNNN.stl");
  std::ofstream(folder_ / "file") << "x";
  EXPECT_THROW(NewHullFolder(folder_ / "file" / "ship", false), FileError);
  EXPECT_THROW(NewHullFolder(folder_ / "file", false), FileError);
}

}  // namespace hull_folder_test
}  // namespace nilas::hull
