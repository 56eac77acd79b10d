/// Hulls of many kinds in all attitudes: which are found right, corrected, doubted or missed.
#include "core/hull/hull_attitude.h"

#include <gtest/gtest.h>

#include "tests/core/hull/hull_family.h"

namespace hull_attitude_test {

using namespace nilas;
using namespace nilas::hull;
using namespace nilas_test;

/// The 24 rotations that put the axes of a frame along those of another.
std::vector<MeshAxes> all_attitudes() {
  std::vector<MeshAxes> all;
  for (int forward = 0; forward < 3; ++forward)
    for (int up = 0; up < 3; ++up)
      for (const int f : {1, -1})
        for (const int u : {1, -1})
          if (forward != up) all.push_back({{forward, f}, {up, u}});
  return all;
}

/// Whether two hulls are as alike as a solid and its image: a ship and itself, or a barge and itself stern first.
bool alike(const HullMeasures& a, const HullMeasures& b) {
  constexpr double k_line = 0.03;  // a line of the views more or less
  const auto near = [](double x, double y) { return std::abs(x - y) < k_line; };
  return (a.size() - b.size()).norm() < 1e-6 * a.size().norm() && near(a.flat_top, b.flat_top) &&
         near(a.flat_bottom, b.flat_bottom) && near(a.full_fore, b.full_fore) && near(a.full_aft, b.full_aft) &&
         near(a.broad_fore, b.broad_fore) && near(a.broad_aft, b.broad_aft);
}

/// How 24 attitudes of one hull are judged.
struct Judged {
  int right = 0;        ///< lies as it should, and is not doubted
  int false_alarm = 0;  ///< lies as it should, and is doubted
  int cured = 0;        ///< Doubted, and lies correctly after the suggested turn.
  int doubted = 0;      ///< Doubted, but lies wrongly after the suggested turn.
  int missed = 0;       ///< lies wrongly, and is not doubted
  bool operator==(const Judged&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Judged& j) {
  return out << "right " << j.right << ", false alarms " << j.false_alarm << ", cured " << j.cured << ", doubted "
             << j.doubted << ", missed " << j.missed;
}

Judged judged(const geometry::TriangleMesh& hull, bool fixed) {
  Judged found;
  const HullMeasures should = measure_hull(hull);
  for (const MeshAxes& attitude : all_attitudes()) {
    const geometry::TriangleMesh mesh = turned(hull, attitude);
    const HullAttitude told = probable_attitude(mesh, fixed);
    const bool right = alike(should, measure_hull(mesh));
    if (right)
      ++(told.as_it_should() ? found.right : found.false_alarm);
    else if (told.as_it_should())
      ++found.missed;
    else
      ++(alike(should, measure_hull(turned(mesh, told.axes))) ? found.cured : found.doubted);
  }
  return found;
}

struct Kind {
  const char* name;
  geometry::TriangleMesh hull;
  Judged expected;
};

void expect_judged(const std::vector<Kind>& kinds) {
  for (const Kind& kind : kinds) EXPECT_EQ(judged(kind.hull, false), kind.expected) << kind.name;
}

TEST(HullAttitude, ShipsAreCuredInAllAttitudes) {
  // right, false alarms, cured, doubted, missed
  const Judged all{.right = 1, .cured = 23};
  expect_judged({{"coaster", coaster(), all},
                 {"icebreaker", generated("icebreaker"), all},
                 {"hollow entrance", mesh::ship_mesh(30, 6), all},
                 {"planing boat", planing_boat(), all},
                 {"yacht", yacht(), all},
                 {"catamaran", catamaran(), all},
                 {"bulb and deckhouse", with_bulb_and_deckhouse(), all},
                 {"double-ender", double_ender(), {.right = 2, .cured = 22}}});
}

TEST(HullAttitude, WhereBowOrDeckCannotBeToldTheAxesStillAre) {
  // blunt bows: stern first alone is missed, and with other mistakes the bow may end up astern
  expect_judged({{"bulk carrier", bulk_carrier(), {.right = 1, .cured = 11, .doubted = 11, .missed = 1}},
                 {"pram bow", pram_icebreaker(), {.right = 1, .cured = 11, .doubted = 11, .missed = 1}},
                 {"submarine", submarine(), {.right = 2, .cured = 10, .doubted = 10, .missed = 2}},
                 // upright walls: on end they are piers, upside down they are the same
                 {"wedge", generated("wedge"), {.right = 2, .cured = 14, .missed = 8}},
                 {"raked barge", raked_barge(), {.right = 2, .cured = 18, .missed = 4}},
                 {"box", mesh::box_mesh({0, -10, 0}, {100, 10, 9}), {.right = 4, .cured = 12, .missed = 8}},
                 {"moonpool", mesh::moonpool_mesh(), {.right = 4, .cured = 12, .missed = 8}}});
}

TEST(HullAttitude, StructuresThatAreRoundOrSquareMayLieAsTheyDo) {
  expect_judged({{"cube", mesh::box_mesh({0, 0, 0}, {1, 1, 1}), {.right = 24}},
                 {"sphere", mesh::bulb_mesh({0, 0, 0}, {1, 1, 1}, 16), {.right = 24}},
                 {"semi-submersible", semisubmersible(), {.right = 4, .cured = 8, .missed = 12}}});
}

/// Further solids that may be intended as they lie.
TEST(HullAttitude, NothingThatMayBeMeantIsDoubted) {
  const std::vector<std::pair<const char*, geometry::TriangleMesh>> meant{
      {"column", mesh::column_mesh({0, 0, 0}, 1, 10, 24)},
      {"cone, point down", mesh::cone_mesh(1, 1.5, 24)},
      {"cone, wide at the foot", cone_foundation(20, 8, 15)},
      {"round buoy", cone_foundation(8, 20, 15)},
      {"pontoons and columns", pontoons_and_columns()},
      {"pier", prism({{-6, -2}, {6, -2}, {8, 0}, {6, 2}, {-6, 2}, {-8, 0}}, 20)},
      {"pier with a nose", prism({{-6, -2}, {6, -2}, {9, 0}, {6, 2}, {-6, 2}}, 12)},
      {"oblique hull", prism({{0, -5}, {40, -5}, {52, -2}, {40, 6}, {0, 5}}, 6)},
      {"barge with deckhouse",
       together({mesh::box_mesh({0, -8, 0}, {60, 8, 4}), mesh::box_mesh({2, -6, 4}, {14, 6, 14})})},
      {"island to starboard", together({coaster(), mesh::box_mesh({40, -10, 9}, {60, -6, 25})})},
      {"broad wedge to push with", prism({{0, -2}, {1, 0}, {0, 2}}, 1)},
      {"flat barge", mesh::box_mesh({0, -5, 0}, {12, 5, 0.4})},
      {"barge.stl", geometry::read_stl(NILAS_SOURCE_DIR "/apps/scenes/verify/barge.stl")},
      {"wedge.stl", geometry::read_stl(NILAS_SOURCE_DIR "/apps/scenes/verify/wedge.stl")},
      {"hulls/icebreaker", geometry::read_stl(NILAS_SOURCE_DIR "/apps/scenes/hulls/icebreaker/fluid.stl")}};
  for (const auto& [name, mesh] : meant)
    for (const bool fixed : {false, true})
      EXPECT_TRUE(probable_attitude(mesh, fixed).as_it_should()) << name << (fixed ? ", fixed" : "");
}

TEST(HullAttitude, NoGeneratedFormIsDoubted) {
  int made = 0;
  for (const double stem : {10, 45, 90})
    for (const double entrance : {10, 40, 80})
      for (const double flare : {0, 20, 45})
        for (const double bow : {0.1, 0.5})
          for (const double beam : {0.1, 0.5})
            for (const double depth : {0.03, 0.1, 0.2}) {
              geometry::TriangleMesh mesh;
              try {
                mesh = generated("icebreaker", {{"stem_angle_deg", stem},
                                                {"entrance_angle_deg", entrance},
                                                {"flare_angle_deg", flare},
                                                {"length", 100},
                                                {"bow_length", 100 * bow},
                                                {"stern_length", 17},
                                                {"beam", 100 * beam},
                                                {"draught", 2},
                                                {"depth", 100 * depth},
                                                {"triangles", 400}});
              } catch (const std::exception&) {
                continue;  // no such form
              }
              ++made;
              EXPECT_TRUE(probable_attitude(mesh, false).as_it_should())
                  << stem << ' ' << entrance << ' ' << flare << ' ' << bow << ' ' << beam << ' ' << depth;
            }
  EXPECT_GT(made, 100);
}

TEST(HullAttitude, AMirroredHullIsOneThatIsTurned) {
  const auto mirrored = [](int axis) {
    geometry::TriangleMesh mesh = coaster();
    for (auto& p : mesh.vertices) p[axis] = -p[axis];
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    return probable_attitude(mesh, false);
  };
  EXPECT_EQ(mirrored(0).axes, (MeshAxes{{0, -1}, {2, 1}}));
  EXPECT_TRUE(mirrored(1).as_it_should());
  EXPECT_EQ(mirrored(2).axes, (MeshAxes{{0, 1}, {2, -1}}));
}

TEST(HullAttitude, AFixedShipThatLiesAcrossIsDoubtedToo) {
  const MeshAxes across{{1, 1}, {2, 1}};
  EXPECT_EQ(probable_attitude(turned(coaster(), {{1, -1}, {2, 1}}), true).axes, across);
}

/// A foundation whose drawing has y up keeps its wide foot below. A floating body of that form is the other way up: its
/// level face is the deck.
TEST(HullAttitude, AFoundationThatLiesAcrossKeepsItsFootBelow) {
  const geometry::TriangleMesh drawn = turned(cone_foundation(20, 8, 15), {{1, 1}, {0, 1}});
  const auto up = [&](bool fixed) { return probable_attitude(drawn, fixed).axes.up; };
  EXPECT_EQ(up(true), (MeshAxis{1, 1}));
  EXPECT_EQ(up(false), (MeshAxis{1, -1}));
}

TEST(HullAxes, AreThoseOfARightHandedFrame) {
  for (const MeshAxes& axes : all_attitudes()) {
    EXPECT_NEAR(axes.to_vessel().determinant(), 1, 1e-15) << axes.forward.name() << axes.up.name();
    EXPECT_EQ(mesh_axis(axes.forward.name()), axes.forward);
  }
  const MeshAxes y_up{{0, 1}, {1, 1}};
  EXPECT_EQ(y_up.to_vessel() * Vec3(1, 2, 3), Vec3(1, -3, 2));
}

}  // namespace hull_attitude_test
