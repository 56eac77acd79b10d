#include "fracture/cut/cut_floe.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/geometry/shape.h"
#include "fracture/cut/smallest_box.h"
#include "tests/support/cut_judge.h"

namespace cut_floe_test {

using namespace nilas;
using namespace nilas::fracture;
using namespace nilas::test;

FloeState plate(double length, double width) {
  FloeState floe;
  floe.outline = {
      {-length / 2, -width / 2}, {length / 2, -width / 2}, {length / 2, width / 2}, {-length / 2, width / 2}};
  floe.thickness = 0.5;
  const geometry::MassProperties m = geometry::prism_properties(floe.outline, floe.thickness, 900);
  floe.mass = m.mass;
  floe.inertia_B = m.inertia;
  return floe;
}

TEST(CutFloe, HalvesOfATurningPlateFlyApartAsTheirCentresMoved) {
  FloeState floe = plate(4, 2);
  floe.pose = {Quat(Eigen::AngleAxisd(k_pi / 2, Vec3::UnitZ())), {10, 20, 0.1}};
  floe.v_GB = {1, 0, 0};
  floe.w_GB = {0, 0, 2};
  const FloeCut cut = cut_floe(floe, {{{0, -5}, {0, 5}}}, {});
  ASSERT_EQ(cut.status, FloeCutStatus::cut);
  ASSERT_EQ(cut.pieces.size(), 2u);
  EXPECT_EQ(cut.crack_length, 2);
  const FloeState& left = cut.pieces[0].state;  // towards -x in B, which is -y in G
  EXPECT_NEAR((left.pose.p - Vec3(10, 19, 0.1)).norm(), 0, 1e-14);
  EXPECT_NEAR((left.v_GB - Vec3(3, 0, 0)).norm(), 0, 1e-14);
  EXPECT_EQ(left.w_GB, floe.w_GB);
  EXPECT_DOUBLE_EQ(left.mass, floe.mass / 2);
  EXPECT_DOUBLE_EQ(cut.pieces[0].area, 4);
  const geometry::MassProperties half = geometry::prism_properties(left.outline, 0.5, 900);
  EXPECT_NEAR((left.inertia_B - half.inertia).norm(), 0, 1e-12 * half.inertia.norm());
  EXPECT_LE(motion_error(floe, cut).worst(), 1e-15 * 4);
}

TEST(CutFloe, PiecesInheritWhatTheIceIs) {
  const FloeState floe = plate(4, 2);
  for (const FloePiece& piece : cut_floe(floe, {{{-5, 0.3}, {5, 0.1}}, {{1, -2}, {0, 2}}}, {}).pieces) {
    EXPECT_EQ(piece.state.thickness, floe.thickness);
    EXPECT_NEAR(piece.state.mass / (piece.area * floe.thickness), 900, 900 * 1e-14);
    EXPECT_NEAR(geometry::polygon_moments(piece.state.outline).centroid.norm(), 0, 1e-15);
    EXPECT_NEAR(geometry::prism_shape(piece.state.outline, floe.thickness).thickness, 0.5, 0);
  }
}

/// A notch that a hull left, and a floe that is wholly within one: the ice goes, whatever pieces may be as small, and
/// is told.
TEST(CutFloe, CrushedIceLeavesWithItsMotion) {
  FloeState floe = plate(4, 2);
  floe.v_GB = {1, 2, 3};
  floe.w_GB = {0.3, 0.2, 0.1};
  PieceLimits limits;
  limits.min_area = 0.5;
  const std::vector<Vec2> notch{{1.5, -0.25}, {2.5, -0.25}, {2.5, 0.25}, {1.5, 0.25}};
  Lines line{notch};
  line[0].push_back(notch[0]);
  const FloeCut cut = cut_floe(floe, line, limits, {{notch}, {}});
  ASSERT_EQ(cut.status, FloeCutStatus::cut) << cut.message;
  ASSERT_EQ(cut.pieces.size(), 1u);
  ASSERT_EQ(cut.extruded.size(), 1u);
  EXPECT_NEAR(cut.pieces[0].area, 8 - 0.25, 1e-15);
  EXPECT_NEAR(cut.extruded_account.mass, floe.mass / 32, 1e-12);
  EXPECT_LE(motion_error(floe, cut).worst(), 1e-15 * 4);
  EXPECT_EQ(cut_floe(floe, line, limits).status, FloeCutStatus::too_small);

  const std::vector<Vec2> all{{-3, -2}, {3, -2}, {3, 2}, {-3, 2}};
  const FloeCut gone = cut_floe(floe, {all}, limits, {{all}, {}});
  EXPECT_EQ(gone.status, FloeCutStatus::cut);
  EXPECT_TRUE(gone.pieces.empty());
  EXPECT_EQ(gone.extruded_account.mass, floe.mass);
}

TEST(CutFloe, SmallPiecesStopTheCutOrBecomeBrash) {
  FloeState floe = plate(4, 2);
  floe.v_GB = {1, 2, 3};
  floe.w_GB = {0.3, 0.2, 0.1};
  const Lines corner{{{1.9, -1}, {2, -0.9}}};
  PieceLimits limits;
  limits.min_area = 0.01;
  const FloeCut refused = cut_floe(floe, corner, limits);
  EXPECT_EQ(refused.status, FloeCutStatus::too_small);
  EXPECT_TRUE(refused.pieces.empty() && refused.brash.empty());
  limits.small = SmallPieces::brash;
  const FloeCut cut = cut_floe(floe, corner, limits);
  ASSERT_EQ(cut.pieces.size(), 1u);
  ASSERT_EQ(cut.brash.size(), 1u);
  EXPECT_NEAR(cut.brash_account.mass, 0.005 * 0.5 * 900, 1e-13);
  EXPECT_LE(motion_error(floe, cut).worst(), 1e-15 * 4);
  limits.min_area = 0;
  EXPECT_EQ(cut_floe(floe, corner, limits).pieces.size(), 2u);
}

TEST(CutFloe, LongPiecesDoTheSame) {
  const FloeState floe = plate(4, 2);
  PieceLimits limits;
  limits.max_aspect = 8;
  EXPECT_EQ(cut_floe(floe, {{{-3, -0.51}, {3, -0.51}}}, limits).status, FloeCutStatus::too_narrow);  // 4 : 0.49
  EXPECT_EQ(cut_floe(floe, {{{-3, -0.49}, {3, -0.49}}}, limits).status, FloeCutStatus::cut);         // 4 : 0.51
  limits.small = SmallPieces::brash;
  EXPECT_EQ(cut_floe(floe, {{{-3, -0.51}, {3, -0.51}}}, limits).brash.size(), 1u);
}

TEST(CutFloe, TellsWhatTheOutlineSays) {
  const FloeState floe = plate(4, 2);
  EXPECT_EQ(cut_floe(floe, {{{-5, 3}, {5, 3}}}, {}).status, FloeCutStatus::uncut);
  const FloeCut ring = cut_floe(floe, {{{0, 0}, {0.5, 0}, {0, 0.5}, {0, 0}}}, {});
  EXPECT_EQ(ring.status, FloeCutStatus::geometry);
  EXPECT_EQ(ring.outline_status, CutStatus::hole);
}

TEST(CutFloe, DemandsAUniformPlateAboutItsCentroid) {
  FloeState heavy = plate(4, 2), shifted = heavy, weightless = heavy;
  heavy.inertia_B *= 1.1;
  for (Vec2& p : shifted.outline) p += Vec2(1e-3, 0);
  weightless.mass = 0;
  for (const FloeState& floe : {heavy, shifted, weightless})
    EXPECT_THROW(cut_floe(floe, {{{0, -5}, {0, 5}}}, {}), ContractError);
}

TEST(SmallestBox, LiesAlongATurnedRectangle) {
  Outline rectangle{{0, 0}, {5, 0}, {5, 2}, {2, 2}, {2, 1}, {0, 2}};
  for (Vec2& p : rectangle) p = Eigen::Rotation2Dd(0.3) * p + Vec2(7, 3);
  const SmallestBox box = smallest_box(rectangle);
  EXPECT_NEAR(box.length, 5, 1e-14);
  EXPECT_NEAR(box.width, 2, 1e-14);
  EXPECT_NEAR(box.aspect(), 2.5, 1e-14);
  EXPECT_TRUE(std::isinf(smallest_box({{0, 0}, {1, 1}, {2, 2}}).aspect()));
}

/// Metrikin's Algorithm 9 tries the direction of every pair of vertices.
TEST(SmallestBox, IsTheSmallestOverTheDirectionsOfAllPairs) {
  RandomStream random(5, "boxes");
  for (int i = 0; i < 50; ++i) {
    const Outline outline = sound_outline(any_shape, 1, Vec2::Zero(), random);
    double least = 1e16;
    for (const Vec2& a : outline)
      for (const Vec2& b : outline) {
        if (a == b) continue;
        const Vec2 along = (b - a).normalized();
        Eigen::AlignedBox2d box;
        for (const Vec2& p : outline) box.extend(Vec2(along.dot(p), along.x() * p.y() - along.y() * p.x()));
        least = std::min(least, box.volume());
      }
    const SmallestBox box = smallest_box(outline);
    EXPECT_NEAR(box.length * box.width, least, 1e-13);
  }
}

}  // namespace cut_floe_test
