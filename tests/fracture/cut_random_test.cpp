/// A thousand random cuts; tests/bench/cut_study.cpp makes a hundred thousand of the same.
#include <gtest/gtest.h>

#include <set>

#include "tests/support/cut_judge.h"
#include "tests/support/test_name.h"

namespace cut_random_test {

using namespace nilas;
using namespace nilas::fracture;
using namespace nilas::test;

constexpr int k_cuts_per_class = 80;

struct RandomCuts : testing::TestWithParam<int> {
  CutClass kind() const { return static_cast<CutClass>(GetParam()); }
  RandomStream random() const { return {1789, k_cut_class_names[GetParam()]}; }
};

using Key = std::pair<double, double>;
Key key(const Vec2& p) { return {p.x(), p.y()}; }

/// Exactly one other piece has each crack edge in the reverse direction.
bool crack_edges_pair_up(const std::vector<CutPiece>& pieces) {
  std::multiset<std::pair<Key, Key>> edges;
  for (const CutPiece& piece : pieces)
    for (std::size_t i = 0; i < piece.outline.size(); ++i)
      if (piece.crack[i]) edges.insert({key(piece.outline[i]), key(piece.outline[(i + 1) % piece.outline.size()])});
  for (const auto& [a, b] : edges)
    if (edges.count({a, b}) != 1 || edges.count({b, a}) != 1) return false;
  return true;
}

/// The outline's vertices are all there, bit for bit.
bool keeps_vertices(const Outline& outline, const std::vector<CutPiece>& pieces) {
  std::set<Key> kept;
  for (const CutPiece& piece : pieces)
    for (const Vec2& p : piece.outline) kept.insert(key(p));
  return std::all_of(outline.begin(), outline.end(), [&](const Vec2& p) { return kept.count(key(p)) > 0; });
}

TEST_P(RandomCuts, LeaveSoundPiecesThatFillTheOutlineWithoutOverlap) {
  RandomStream stream = random();
  int refused = 0, cuts = 0;
  for (int i = 0; i < k_cuts_per_class; ++i) {
    const CutCase made = cut_case(kind(), stream);
    const CutResult cut = cut_outline(made.outline, made.cracks);
    ASSERT_NE(cut.status, CutStatus::rounding) << i;
    ASSERT_NE(cut.status, CutStatus::bad_outline) << i;
    refused += cut.pieces.empty();
    if (cut.pieces.empty()) continue;
    cuts += cut.status == CutStatus::cut;
    for (const CutPiece& piece : cut.pieces) ASSERT_TRUE(sound(piece.outline)) << i;
    EXPECT_TRUE(crack_edges_pair_up(cut.pieces)) << i;
    EXPECT_TRUE(keeps_vertices(made.outline, cut.pieces)) << i;
    // separating axes in doubles see exact neighbours apart to a few roundings
    EXPECT_LE(deepest_overlap(cut.pieces), std::max(1e-15, 0.1 * snap_resolution(made.outline))) << i;
    EXPECT_LE(deepest_overlap(cut.pieces), 1e-12) << i;
    // No edge moves by more than the resolution. About the origin, that is 1e-12 of the area; at 1e6 m off, doubles are
    // 1.2e-10 m apart and a floe of some metres keeps its area to 1e-9.
    const double error = area_error(made.outline, cut.pieces);
    EXPECT_LE(error, snap_resolution(made.outline) * perimeter(made.outline)) << i;
    if (kind() != CutClass::far_off) {
      EXPECT_LE(error, 1e-12 * geometry::polygon_moments(made.outline).area) << i;
    }
  }
  if (!may_enclose(kind())) {
    EXPECT_EQ(refused, 0);
  }
  // lines along the edges of a convex outline cut nothing; all other kinds mostly cut
  EXPECT_GT(cuts, kind() == CutClass::along_edges ? 0 : k_cuts_per_class / 4);
}

TEST_P(RandomCuts, KeepMassMomentumAngularMomentumAndEnergy) {
  RandomStream stream = random();
  for (int i = 0; i < k_cuts_per_class; ++i) {
    CutCase made = cut_case(kind(), stream);
    const Vec2 centroid = geometry::polygon_moments(made.outline).centroid;
    const FloeState floe = random_floe(made.outline, stream);
    if (!sound(floe.outline)) continue;
    for (auto& crack : made.cracks)
      for (Vec2& p : crack) p -= centroid;
    PieceLimits limits;
    limits.min_area = 1e-3 * geometry::polygon_moments(floe.outline).area;
    limits.max_aspect = 8;
    limits.small = SmallPieces::brash;
    const FloeCut cut = cut_floe(floe, made.cracks, limits);
    ASSERT_TRUE(cut.status != FloeCutStatus::geometry || may_enclose(kind())) << cut.message;
    if (cut.status != FloeCutStatus::cut) continue;
    const MotionError error = motion_error(floe, cut);
    EXPECT_LE(error.mass, 1e-12);
    EXPECT_LE(error.momentum, 1e-12);
    EXPECT_LE(error.angular_momentum, 1e-12);
    EXPECT_LE(error.energy, 1e-12);
    // The position of a piece in G is rounded by one unit in the last place of the largest coordinate in either
    // direction.
    double largest = 0;
    for (const Vec2& p : floe.outline) largest = std::max(largest, floe.pose.p.norm() + p.norm());
    EXPECT_LE(deepest_overlap(pieces_in_plane(floe, cut)), 4 * 0x1p-52 * largest) << i;
  }
}

std::string class_name(const testing::TestParamInfo<int>& tested) { return test_name(k_cut_class_names[tested.param]); }

INSTANTIATE_TEST_SUITE_P(Fracture, RandomCuts, testing::Range(0, k_num_cut_classes), class_name);

}  // namespace cut_random_test
