/// Faults that drawing programs leave in meshes are mended, or refused with the place.
#include "core/mesh/mend/mend.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "core/base/error.h"
#include "core/base/machine.h"
#include "tests/core/mesh/hull_shapes.h"
#include "tests/support/refusal.h"

namespace nilas::mesh {
namespace mend_test {

MendSettings settings(double length) { return {1e-5 * length, 0.05 * length}; }

bool did(const MendedMesh& mended, const std::string& what) {
  return std::any_of(mended.done.begin(), mended.done.end(),
                     [&](const MeshNote& note) { return note.what.find(what) != std::string::npos; });
}

/// Closed, outward, of the volume.
void expect_sound(const MendedMesh& mended, double volume, double share) {
  for (const auto& note : mended.open) ADD_FAILURE() << note.count << " " << note.what;
  EXPECT_TRUE(geometry::find_defects(mended.mesh).sound()) << geometry::find_defects(mended.mesh).text();
  EXPECT_NEAR(geometry::signed_volume(mended.mesh), volume, share * volume);
}

TEST(Mend, SoundMeshesStayAsTheyAre) {
  for (const auto& mesh : {cone_mesh(1, 1.5, 24), moonpool_mesh(), ship_mesh(40, 8)}) {
    const MendedMesh mended = mend(soup_of({mesh}), settings(4));
    EXPECT_TRUE(mended.done.empty());
    expect_sound(mended, geometry::signed_volume(mesh), 1e-6);
    EXPECT_EQ(mended.mesh.triangles.size(), mesh.triangles.size());
  }
}

TEST(Mend, FlippedFacesAreTurnedAndCounted) {
  geometry::TriangleMesh ship = ship_mesh(40, 8);
  for (std::size_t k = 0; k < ship.triangles.size(); k += 7) std::swap(ship.triangles[k][0], ship.triangles[k][1]);
  const MendedMesh mended = mend(soup_of({ship}), settings(6));
  expect_sound(mended, geometry::signed_volume(ship_mesh(40, 8)), 1e-6);
  ASSERT_TRUE(did(mended, "turned to the winding"));
  EXPECT_EQ(mended.done.front().count, (ship.triangles.size() + 6) / 7);
}

TEST(Mend, AHullWoundInwardsIsTurned) {
  geometry::TriangleMesh cone = cone_mesh(1, 1.5, 24);
  for (auto& t : cone.triangles) std::swap(t[0], t[1]);
  const MendedMesh mended = mend(soup_of({cone}), settings(2));
  expect_sound(mended, geometry::signed_volume(cone_mesh(1, 1.5, 24)), 1e-6);
  EXPECT_TRUE(did(mended, "inwards"));
}

TEST(Mend, SmallHolesAreFilledLargeOnesRefusedWithTheirPlace) {
  geometry::TriangleMesh ship = ship_mesh(40, 8);
  const double volume = geometry::signed_volume(ship);
  const auto below_deck = [&](const auto& t) {
    return std::all_of(t.begin(), t.end(), [&](int v) { return ship.vertices[v].z() < 0.5; });
  };
  for (int hole = 0; hole < 2; ++hole)
    ship.triangles.erase(std::find_if(ship.triangles.begin() + 101 + 200 * hole, ship.triangles.end(), below_deck));
  const MendedMesh mended = mend(soup_of({ship}), settings(6));
  expect_sound(mended, volume, 1e-4);
  EXPECT_TRUE(did(mended, "holes filled"));
  geometry::TriangleMesh open = box_mesh({0, 0, 0}, {4, 1, 1});
  std::erase_if(open.triangles, [&](const auto& t) {
    return std::all_of(t.begin(), t.end(), [&](int v) { return open.vertices[v].z() == 1; });
  });
  const MendedMesh left = mend(soup_of({open}), settings(4));
  ASSERT_EQ(left.open.size(), 1u);
  EXPECT_NE(left.open[0].what.find("4.12"), std::string::npos) << left.open[0].what;
  EXPECT_LT((left.open[0].places.at(0) - Vec3(2, 0.5, 1)).norm(), 1e-12);
  const MendedMesh filled = mend(soup_of({open}), {1e-5, 5});
  expect_sound(filled, 4, 1e-9);
}

TEST(Mend, TJunctionsAndCracksAreClosed) {
  // a cube whose top is cut finer than its sides, and stands a little off them
  geometry::TriangleMesh cube = box_mesh({0, 0, 0}, {1, 1, 1});
  std::erase_if(cube.triangles, [&](const auto& t) {
    return std::all_of(t.begin(), t.end(), [&](int v) { return cube.vertices[v].z() == 1; });
  });
  PolygonSoup soup = soup_of({cube});
  constexpr int k_cells = 4;
  constexpr double k_crack = 3e-6;
  for (int i = 0; i < k_cells; ++i)
    for (int j = 0; j < k_cells; ++j) {
      const int first = static_cast<int>(soup.points.size());
      for (const auto& [a, b] : {std::pair{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}})
        soup.points.emplace_back(a / 4.0, b / 4.0, 1 + k_crack);
      soup.polygons.push_back({first, first + 1, first + 2, first + 3});
    }
  const MendedMesh mended = mend(soup, settings(1));
  expect_sound(mended, 1, 1e-5);
  EXPECT_TRUE(did(mended, "neighbour's edge"));
  // The reversed winding of the top shows only once it has met the sides.
  for (auto& loop : soup.polygons)
    if (loop.size() == 4) std::reverse(loop.begin(), loop.end());
  const MendedMesh turned = mend(soup, settings(1));
  expect_sound(turned, 1, 1e-5);
  EXPECT_TRUE(did(turned, "turned to the winding of their neighbours"));
  std::set<std::string> kinds;
  for (const auto& note : turned.done) EXPECT_TRUE(kinds.insert(note.what).second) << note.what << " told twice";
}

TEST(Mend, DuplicateAndNestedShellsAreDropped) {
  const geometry::TriangleMesh ship = ship_mesh(30, 6);
  const MendedMesh twice = mend(soup_of({ship, ship}), settings(6));
  expect_sound(twice, geometry::signed_volume(ship), 1e-6);
  EXPECT_TRUE(did(twice, "more than once"));
  const MendedMesh lined =
      mend(soup_of({box_mesh({0, 0, 0}, {4, 1, 1}), box_mesh({1, 0.2, 0.2}, {3, 0.8, 0.8})}), settings(4));
  expect_sound(lined, 4, 1e-9);
  EXPECT_TRUE(did(lined, "inside another"));
}

TEST(Mend, OverlappingShellsAreUnited) {
  const MendedMesh platform = mend(soup_of(semisubmersible_shells(16)), settings(3));
  expect_sound(platform, semisubmersible_volume(16), 1e-6);
  EXPECT_TRUE(did(platform, "united"));
  // half of the ellipsoid stands out of the stem: the union lies between the ship and both together
  const geometry::TriangleMesh ship = ship_mesh(40, 8), bulb = bulb_mesh({5.9, 0, 0.12}, {0.5, 0.09, 0.1}, 8);
  const MendedMesh both = mend(soup_of({ship, bulb}), settings(6));
  const double low = geometry::signed_volume(ship) + 0.4 * geometry::signed_volume(bulb),
               high = geometry::signed_volume(ship) + geometry::signed_volume(bulb);
  expect_sound(both, 0.5 * (low + high), 0.5 * (high - low) / (low + high) * 2);
}

/// Mended, or refused as a user's mistake: neither a crash, nor another error, nor a result that is not sound.
void expect_answer(const PolygonSoup& soup, const MendSettings& how) {
  try {
    const MendedMesh mended = mend(soup, how);
    EXPECT_TRUE(!mended.open.empty() || geometry::find_defects(mended.mesh).sound())
        << geometry::find_defects(mended.mesh).text();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()).find("CGAL"), std::string::npos) << e.what();
  }
}

const std::vector<Vec3> k_box_corners{{0, -0.5, 0}, {4, -0.5, 0}, {4, 0.5, 0}, {0, 0.5, 0},
                                      {0, -0.5, 1}, {4, -0.5, 1}, {4, 0.5, 1}, {0, 0.5, 1}};

TEST(Mend, WhatCgalDoesNotExpectIsAnswered) {
  expect_answer({{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}}, {4e-5, 10});
  auto corners = k_box_corners;
  corners[2] = {3.999999, 0.5001, 1e-5};  // filled, the four faces cross
  expect_answer({corners, {{7, 6, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {7, 3, 6}}}, {4e-5, 10});
}

TEST(Mend, FacesThatVisitACornerTwiceAreSplitThere) {
  expect_answer({k_box_corners, {{4, 7, 0, 5, 6, 4, 0, 2, 3}}}, {4e-5, 10});
  // two sides of a box as one loop through a corner they share
  const MendedMesh mended = mend(
      {k_box_corners, {{0, 3, 2, 1, 0, 1, 5, 4}, {4, 5, 6, 7}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}}, settings(4));
  expect_sound(mended, 4, 1e-9);
  EXPECT_TRUE(did(mended, "more than once split"));
}

TEST(Mend, AFaceOfManyRepeatedCornersTakesNoTime) {
  PolygonSoup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{}}};
  constexpr int k_corners = 300000;
  for (int k = 0; k < k_corners; ++k) soup.polygons[0].push_back(k % 3);
  const double start = processor_seconds();
  expect_answer(soup, settings(1));
  EXPECT_LT(processor_seconds() - start, 20);
}

TEST(Mend, AFaceOfTooManyCornersIsRefusedWithItsPlace) {
  PolygonSoup soup{{}, {{}}};
  constexpr int k_corners = 10001;
  for (int k = 0; k < k_corners; ++k) {
    soup.points.emplace_back(7 + std::cos(2 * k_pi * k / k_corners), std::sin(2 * k_pi * k / k_corners), 0);
    soup.polygons[0].push_back(k);
  }
  test::expect_refusal([&] { mend(soup, settings(2)); }, {"(8, 0, 0)", "10001", "10000"});
}

bool left_open(const MendedMesh& mended, const std::string& what) {
  return std::any_of(mended.open.begin(), mended.open.end(),
                     [&](const MeshNote& note) { return note.what.find(what) != std::string::npos; });
}

TEST(Mend, AFaceThatCrossesItselfIsNamedWithItsPlace) {
  const MendedMesh mended =
      mend({k_box_corners, {{0, 3, 2, 1}, {4, 6, 5, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}},
           settings(4));
  ASSERT_FALSE(mended.open.empty());
  for (const auto& note : mended.open)
    for (const auto& place : note.places) EXPECT_GT(place.z(), 0.4) << note.what;
}

TEST(Mend, NothingWithAVolumeIsSaidSo) {
  const std::vector<Vec3> corners{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}};
  const PolygonSoup fin{corners, {{0, 1, 2, 3}, {3, 2, 1, 0}}};
  test::expect_refusal([&] { mend(fin, settings(4)); }, {"nothing that encloses a volume"});
}

TEST(Mend, AnInnerWallIsCalledSo) {
  PolygonSoup soup = soup_of({box_mesh({0, 0, 0}, {2, 1, 1}), box_mesh({2, 0, 0}, {4, 1, 1})});
  int walls = 0;  // one of the two ends that meet stays
  std::erase_if(soup.polygons, [&](const auto& loop) {
    return std::all_of(loop.begin(), loop.end(), [&](int v) { return soup.points[v].x() == 2; }) && ++walls > 2;
  });
  ASSERT_EQ(walls, 4);
  const MendedMesh mended = mend(soup, settings(4));
  ASSERT_TRUE(left_open(mended, "more than two faces"));
  EXPECT_FALSE(left_open(mended, "holes"));
  EXPECT_EQ(mended.open[0].count, 4u);
  for (const auto& place : mended.open[0].places) EXPECT_EQ(place.x(), 2) << place.transpose();
}

TEST(Mend, PointsThatRoundingJoinsArePartedOrNamed) {
  // a funnel from the top whose point ends two microns above one from below; float32 cannot tell them apart at 100 m
  PolygonSoup soup;
  for (const auto& p : k_box_corners) soup.points.push_back(p + Vec3(100, 100.5, 100));
  soup.points.emplace_back(102, 100.5, 101);
  soup.points.emplace_back(102, 100.5, 101 - 2e-6);
  soup.polygons = {{4, 5, 8},    {5, 6, 8},    {6, 7, 8}, {7, 4, 8}, {0, 1, 5, 4}, {1, 2, 6, 5},
                   {2, 3, 7, 6}, {3, 0, 4, 7}, {0, 3, 9}, {3, 2, 9}, {2, 1, 9},    {1, 0, 9}};
  const MendedMesh mended = mend(soup, {1e-9, 1e-9});
  if (mended.open.empty()) return expect_sound(mended, geometry::signed_volume(mended.mesh), 0);
  EXPECT_LT((mended.open[0].places.at(0) - Vec3(102, 100.5, 101)).norm(), 1e-4);
}

TEST(Mend, UnusedPointsMayLieAnywhereAndGapsMayBeTiny) {
  PolygonSoup soup = soup_of({box_mesh({0, 0, 0}, {4, 1, 1})});
  soup.points.emplace_back(1e300, 0, 0);
  expect_sound(mend(soup, settings(4)), 4, 1e-9);
  expect_sound(mend(soup, {1e-300, 1}), 4, 1e-9);
}

/// A shape of a few faces with something wrong.
class Damage {
 public:
  explicit Damage(std::uint64_t seed) : random_(seed) {}
  PolygonSoup soup() {
    PolygonSoup made = below(4) == 0 ? loose() : soup_of({box_mesh({0, -0.5, 0}, {4, 0.5, 1})});
    if (below(3) == 0) made = soup_of({box_mesh({0, -0.5, 0}, {4, 0.5, 1}), cone_mesh(0.3 + part(), 1 + part(), 5)});
    for (std::size_t k = below(6); k > 0; --k) hurt(made);
    return made;
  }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_()) % n; }

 private:
  double part() { return static_cast<double>(below(1000)) / 1000; }
  /// Points of a coarse grid, so that many are equal or in one plane.
  Vec3 point() {
    return {static_cast<double>(below(5)), static_cast<double>(below(3)) / 2, static_cast<double>(below(3)) / 2};
  }
  std::vector<int> loop(std::size_t points) {
    std::vector<int> corners(3 + below(6));
    for (int& v : corners) v = static_cast<int>(below(points));
    return corners;
  }
  PolygonSoup loose() {
    PolygonSoup made;
    for (int k = 0; k < 8; ++k) made.points.push_back(point());
    for (int k = 0; k < 8; ++k) made.polygons.push_back(loop(made.points.size()));
    return made;
  }
  void hurt(PolygonSoup& soup) {
    auto& points = soup.points;
    auto& polygons = soup.polygons;
    const std::size_t v = below(points.size()), f = below(polygons.size());
    switch (below(6)) {
      case 0:
        points[v] = point();
        break;
      case 1:
        points[v] += 1e-6 * (1 + 100 * part()) * Vec3(1, 1, -1);
        break;
      case 2:
        points[v] = points[below(points.size())];
        break;
      case 3:
        polygons.push_back(below(2) == 0 ? polygons[f] : loop(points.size()));
        break;
      case 4:
        std::reverse(polygons[f].begin(), polygons[f].end());
        break;
      default:
        if (polygons.size() > 1) polygons.erase(polygons.begin() + static_cast<std::ptrdiff_t>(f));
    }
  }
  std::mt19937_64 random_;
};

TEST(Mend, DamagedShapesAreAnswered) {
  constexpr std::uint64_t k_shapes = 300;
  for (std::uint64_t seed = 1; seed <= k_shapes; ++seed) {
    SCOPED_TRACE(seed);
    Damage damage(seed);
    const PolygonSoup soup = damage.soup();
    expect_answer(soup, {damage.below(2) == 0 ? 4e-5 : 1e-2, damage.below(2) == 0 ? 0.2 : 10});
  }
}

TEST(Mend, FacesThatCrossAreCutApartOrNamed) {
  geometry::TriangleMesh ship = ship_mesh(40, 8);
  const double volume = geometry::signed_volume(ship);
  Vec3 place = Vec3::Zero();
  for (auto& p : ship.vertices)  // one corner of the side pushed through the opposite side
    if (place.isZero() && p.y() > 0.5 && p.z() > 0.2 && p.z() < 0.5) {
      place = p;
      p.y() = -1.1 * p.y();
    }
  const MendedMesh mended = mend(soup_of({ship}), settings(6));
  if (mended.open.empty()) {
    expect_sound(mended, volume, 0.03);
    EXPECT_TRUE(did(mended, "cross"));
  } else {
    EXPECT_NE(mended.open[0].what.find("cross"), std::string::npos);
    EXPECT_LT(std::abs(mended.open[0].places.at(0).x() - place.x()), 0.3);
  }
}

}  // namespace mend_test
}  // namespace nilas::mesh
