/// Random pairs against brute force, class by class (tests/support/pair_classes.h): a hundredth of those that
/// `./dev bench collision` goes through.
#include <gtest/gtest.h>

#include <ostream>

#include "tests/support/pair_judge.h"

namespace nilas::pairs {

void PrintTo(const PairClass& c, std::ostream* out) { *out << c.name; }

namespace {

class OracleTest : public testing::TestWithParam<PairClass> {};

void expect_truth(const PairClass& c, const Tally& tally) {
  EXPECT_EQ(tally.pairs, k_batch);
  EXPECT_GT(tally.contacts, k_batch / 2);
  EXPECT_EQ(tally.missed, 0);
  EXPECT_EQ(tally.surplus, 0);
  EXPECT_EQ(tally.wrong_normals, 0);
  EXPECT_EQ(tally.wrong_depths, 0) << tally.worst_depth << " sizes, " << tally.worst_ulps << " ulps";
  EXPECT_LT(tally.worst_surface, c.place);
  EXPECT_TRUE(tally.ties == 0 || c.meeting == Meeting::same_place) << tally.ties;
}

TEST_P(OracleTest, FindsTheBestAxisAndTheTrueGaps) {
  const PairClass& c = GetParam();
  const auto [first_seen, remembered] = tally_batch(c, 0);
  {
    SCOPED_TRACE("seen for the first time");
    expect_truth(c, first_seen);
  }
  SCOPED_TRACE("remembered from nearby");
  expect_truth(c, remembered);
  RecordProperty("contacts", static_cast<int>(first_seen.contacts));
  RecordProperty("kept_axes", static_cast<int>(remembered.kept_axes));
  const bool remembers = !has_cylinder(c) && c.meeting != Meeting::same_place;
  EXPECT_GE(remembered.kept_axes, remembers ? k_batch / 10 : 0);
}

/// Test names know letters, digits and underscores only.
std::string test_name(const testing::TestParamInfo<PairClass>& one) {
  std::string name = one.param.name;
  std::replace(name.begin(), name.end(), '-', 'm');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Pairs, OracleTest, testing::ValuesIn(all_classes()), test_name);

/// Of this pair of plates, one a little above the other, two edges cross well inside both and yet on the far side of
/// them: their axis goes through both plates, six times as deep as the best.
TEST(ThinPlates, AreNotPushedThroughEachOther) {
  const auto classes = all_classes();
  const auto c = std::find_if(classes.begin(), classes.end(),
                              [](const PairClass& one) { return one.name == std::string("plates_1000_afloat"); });
  ASSERT_NE(c, classes.end());
  RandomStream random(9, c->name);
  for (int k = 0; k < 154; ++k) draw_pair(*c, random);
  const KnownPair known = find_truth(*c, draw_pair(*c, random));
  ASSERT_NEAR(known.parts[0].gap.s, -4.687e-4, 1e-7);
  Tally tally;
  judge(known, 0, ContactDetector().detect(known.bodies, 0), tally);
  EXPECT_EQ(tally.contacts, 1);
  EXPECT_EQ(tally.wrong_normals + tally.wrong_depths, 0) << tally.worst_depth;
}

// The oracle itself, where the answer is known.

TEST(Oracle, DepthOfABoxInABoxAndOfACylinderInABox) {
  Bodies bodies;
  add_body(bodies, box_shape({2, 2, 1}), {0, 0, 0});
  add_body(bodies, box_shape({1, 1, 1}), {0.2, 0.1, 0.9});
  add_body(bodies, cylinder_shape(0.5, 2), {0, 1.4, 0.2}, Quat(Eigen::AngleAxisd(k_pi / 2, Vec3::UnitX())));
  const auto solid = [&](int b) { return oracle::posed(bodies, b); };
  const auto boxes = oracle::true_gap(solid(0), solid(1));
  EXPECT_NEAR(boxes.s, -0.1, 1e-15);
  EXPECT_NEAR((boxes.n - Vec3::UnitZ()).norm(), 0, 1e-15);
  EXPECT_NEAR(oracle::true_gap(solid(0), solid(2)).s, -0.6, 1e-15);
  EXPECT_NEAR(oracle::true_gap(solid(1), solid(0)).s, -0.1, 1e-15);
}

TEST(Oracle, DistanceOfVertexEdgeAndRim) {
  Bodies bodies;
  add_body(bodies, box_shape({2, 2, 2}), {0, 0, 0});
  add_body(bodies, box_shape({2, 2, 2}), {2.3, 2.4, 0.5});
  add_body(bodies, cylinder_shape(1, 2), {2.3, 0, 2.4});
  const auto solid = [&](int b) { return oracle::posed(bodies, b); };
  const auto edges = oracle::true_gap(solid(0), solid(1)), rim = oracle::true_gap(solid(0), solid(2));
  EXPECT_NEAR(edges.s, 0.5, 1e-15);
  EXPECT_NEAR((edges.n - Vec3(0.6, 0.8, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR(rim.s, 0.5, 1e-15);
  EXPECT_NEAR((rim.n - Vec3(0.6, 0, 0.8)).norm(), 0, 1e-7);
}

TEST(Oracle, DistanceOfTwoRims) {
  Bodies bodies;
  add_body(bodies, cylinder_shape(1, 2), {0, 0, 0});
  add_body(bodies, cylinder_shape(2, 2), {3 + 0.3, 0, 2.4});
  const auto gap = oracle::true_gap(oracle::posed(bodies, 0), oracle::posed(bodies, 1));
  EXPECT_NEAR(gap.s, 0.5, 1e-15);
  EXPECT_NEAR((gap.n - Vec3(0.6, 0, 0.8)).norm(), 0, 1e-7);
}

}  // namespace
}  // namespace nilas::pairs
