/// Mistakes with hulls are reported in sentences that name the remedy.
#include "core/hull/hull_doubts.h"

#include <gtest/gtest.h>

#include "tests/core/hull/hull_family.h"

namespace hull_doubts_test {

using namespace nilas;
using namespace nilas::hull;
using namespace nilas_test;

geometry::TriangleMesh scaled(geometry::TriangleMesh mesh, double factor) {
  for (auto& p : mesh.vertices) p *= factor;
  return mesh;
}

/// The only doubt, or a description of the doubts where there is not exactly one.
std::string only_doubt(const geometry::TriangleMesh& mesh, const HullUse& use = {}) {
  const auto doubts = hull_doubts(mesh, use);
  if (doubts.size() == 1) return doubts.front();
  return std::to_string(doubts.size()) + " doubts" + (doubts.empty() ? "" : ": " + doubts.front());
}

void expect_words(const std::string& text, const std::vector<std::string>& words) {
  for (const auto& word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
}

TEST(HullDoubts, AHullWithYForwardIsToldWithTheCure) {
  const geometry::TriangleMesh across = turned(coaster(), {{1, -1}, {2, 1}});
  EXPECT_EQ(
      only_doubt(across),
      "The hull is 20 m long (x), 100 m wide (y) and 9 m high (z), and its port and starboard sides are not alike. "
      "It probably lies across, with y forward. In a hull x must point forward, y to port and z up. Turn it: nilas "
      "hull MESH --forward y");
}

TEST(HullDoubts, NamesTheMistake) {
  struct Case {
    MeshAxes lies;  ///< the axes of the right hull that its mesh has as x and z
    std::vector<std::string> words;
  };
  const MeshAxis x{0, 1}, y{1, 1}, z{2, 1}, aft{0, -1}, down{2, -1};
  for (const auto& c :
       std::vector<Case>{{{x, down}, {"level at the bottom", "It is probably upside down, with -z up", "--up -z"}},
                         {{aft, z}, {"sharp at its aft end", "stern first, with -x forward", "--forward -x"}},
                         {{aft, down}, {"upside down and stern first", "--forward -x --up -z"}},
                         {{x, y}, {"lies on its side, with -y up", "--up -y"}},
                         {{z, y}, {"across and on its side", "--forward y --up x"}},
                         {{y, x}, {"stands on end, with z forward and y up", "--forward z --up y"}}})
    expect_words(only_doubt(turned(coaster(), c.lies)), c.words);
}

TEST(HullDoubts, TheCureIsInTheAxesAndTheUnitOfTheFile) {
  // a file in millimetres with y up and z aft was taken with --up y
  const MeshAxes file{{2, -1}, {1, 1}}, taken{{0, 1}, {1, 1}};
  const Mat3 R = file.to_vessel();
  geometry::TriangleMesh drawn = coaster();
  for (auto& p : drawn.vertices) p = R.transpose() * p;
  const std::string doubt = only_doubt(turned(drawn, taken), {.file = "ship.obj", .drawn = taken, .scale = 0.001});
  expect_words(doubt, {"nilas hull ship.obj --forward -z --up y --scale 0.001"});
}

TEST(HullDoubts, UnitsThatMakeAHullTooLongOrTooShort) {
  const geometry::TriangleMesh full = coaster(), model = scaled(full, 0.06);
  EXPECT_TRUE(hull_doubts(full, {}).empty());
  EXPECT_TRUE(hull_doubts(model, {}).empty());
  expect_words(only_doubt(scaled(full, 1e3)),
               {"100000 m long", "in millimetres: it is then 100 m long", "--scale 0.001"});
  expect_words(only_doubt(scaled(full, 1e2)), {"in centimetres: it is then 100 m long", "--scale 0.01"});
  expect_words(only_doubt(scaled(model, 1e3)), {"in millimetres: it is then 6 m long"});
  expect_words(only_doubt(scaled(model, 1e2)), {"in centimetres: it is then 6 m long", "in feet: it is then 182.9 m"});
  expect_words(only_doubt(scaled(full, 1e-3), {.scale = 1e-3}),
               {"only 0.1 m long", "in metres, and was taken in millimetres: it is then 100 m long (nilas hull MESH)"});
  // feet for metres make no length that no ship has
  EXPECT_TRUE(hull_doubts(scaled(full, 1 / 0.3048), {}).empty());
}

TEST(HullDoubts, FeetShowInTheMass) {
  const geometry::TriangleMesh feet = scaled(coaster(), 1 / 0.3048);
  const double afloat = 9500;
  const std::string placed = only_doubt(feet, {.displaced = afloat / std::pow(0.3048, 3), .mass_afloat = afloat});
  expect_words(placed, {"35.3 times", "in feet", "--scale 0.3048"});
  expect_words(only_doubt(feet, {.draught = 0.6, .displaced = afloat, .mass_afloat = afloat}),
               {"large for its mass", "feet"});
  expect_words(only_doubt(feet, {.displaced = 5 * afloat, .mass_afloat = afloat}), {"5 times", "mass", "unit"});
  EXPECT_TRUE(hull_doubts(feet, {.draught = 20, .displaced = afloat, .mass_afloat = afloat}).empty());
  EXPECT_TRUE(hull_doubts(feet, {.displaced = 2 * afloat, .mass_afloat = afloat}).empty());
  expect_words(only_doubt(coaster(), {.draught = 0.006}), {"0.006 m", "another unit"});
}

TEST(HullDoubts, HalfAHull) {
  for (const double side : {1.0, -1.0}) {
    geometry::TriangleMesh half = port_half(coaster());
    for (auto& p : half.vertices) p.y() *= side;
    if (side < 0)
      for (auto& t : half.triangles) std::swap(t[1], t[2]);
    expect_words(only_doubt(half), {"half a hull", "Mirror it"});
  }
  EXPECT_TRUE(hull_doubts(mesh::box_mesh({0, 0, 0}, {100, 20, 9}), {}).empty()) << "a barge drawn from one side on";
}

TEST(HullDoubts, AGeneratedHullIsNotTurned) {
  const geometry::TriangleMesh upside_down = turned(generated("icebreaker"), {{0, 1}, {2, -1}});
  EXPECT_EQ(hull_doubts(upside_down, {}).size(), 1u);
  EXPECT_TRUE(hull_doubts(upside_down, {.generated = true}).empty());
}

}  // namespace hull_doubts_test
