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

/// Two bodies whose best direction is near to a cylinder's axis or among other tops of nearly the same height.
struct NarrowTop {
  const char* name;
  Shape a, b;
  Quat q_a, q_b;
  Vec3 p_b;
  double gap;  ///< [m]
};

void PrintTo(const NarrowTop& top, std::ostream* out) { *out << top.name; }

class NarrowTopTest : public testing::TestWithParam<NarrowTop> {};

TEST_P(NarrowTopTest, IsFound) {
  const NarrowTop& top = GetParam();
  Bodies bodies;
  add_body(bodies, top.a, Vec3::Zero(), top.q_a);
  add_body(bodies, top.b, top.p_b, top.q_b);
  PairClass c{};
  c.size = 1;
  const KnownPair known = find_truth(c, std::move(bodies));
  EXPECT_NEAR(known.parts[0].gap.s, top.gap, k_right_depth);
  Tally tally;
  judge(known, 0, ContactDetector().detect(known.bodies, 0), tally);
  EXPECT_EQ(tally.contacts, 1);
  EXPECT_EQ(tally.wrong_normals, 0);
  EXPECT_EQ(tally.wrong_depths, 0) << tally.worst_depth;
}

INSTANTIATE_TEST_SUITE_P(
    OfCylinders, NarrowTopTest,
    testing::Values(
        NarrowTop{"rim_along_an_edge",
                  cylinder_shape(0x1.006eaf6bfa056p-2, 0x1.60508ee8878ccp-2),
                  box_shape({0x1.512815da76b76p-1, 0x1.f80109361afcp-1, 0x1.e8659a90e50a2p-1}),
                  Quat(0.82221897576009317, -0.2891351464640326, 0.47965985392076455, -0.10140634849927574),
                  Quat(-0.59217857118666994, -0.50923637985773984, 0.56279603545394041, 0.27067225889260393),
                  {-0.57759576660450518, -0.34645459432184894, -0.35543889214956137},
                  -0.0046146083832327711},
        NarrowTop{"rims_16_and_6_degrees_from_their_axes",
                  cylinder_shape(0x1.340e1d17b9a67p-3, 0x1.4ab6a0351c3e9p-1),
                  cylinder_shape(0x1.cd1924be52365p-3, 0x1.870f03733b97cp-1),
                  Quat(0.2586870146204821, -0.70221311118417995, -0.12028879214345789, -0.65231003474762306),
                  Quat(0.68718980290709875, -0.32158242059154241, 0.64778620402824072, -0.068760129564085296),
                  {0.78886776630818112, -0.034548172972779893, -0.004461485634464483},
                  -0.001959329105991503},
        NarrowTop{"rim_and_rim_rather_than_side",
                  cylinder_shape(0x1.59c7b812c2b8dp-3, 0x1.a45349c9fb3bp-3),
                  cylinder_shape(0x1.258d369833662p-3, 0x1.8b40712f3fa7p-2),
                  Quat(0.37524372758571123, -0.60207497829764089, 0.0023680691680825596, -0.70476397301784033),
                  Quat(-0.025278226835644159, -0.86650355259855261, -0.32986242078031791, -0.37379590867455065),
                  {0.24845180155907612, 0.14897985154321977, 0.14638559397709125},
                  -9.1200962388543472e-05},
        NarrowTop{"rims_next_to_a_cap",
                  cylinder_shape(0x1.4ed9f57f2423cp-2, 0x1.7682783a88cep-2),
                  cylinder_shape(0x1.b6cc86b61ad1p-2, 0x1.a3927071fc30cp-1),
                  Quat(-0.75824765353377821, 0.2210351984291565, -0.057814172718445231, 0.61062382724455222),
                  Quat(0.18194269713119535, -0.25316569095949182, -0.38622226312310293, 0.86812231358818204),
                  {-0.24190173182241398, -0.15735358361809543, -0.60385917902507058},
                  -0.00010115554837938912}),
    [](const testing::TestParamInfo<NarrowTop>& one) { return one.param.name; });

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
