/// Random pairs against brute force, class by class (tests/support/collision/pair_classes.h): a hundredth of those of
/// `./dev bench collision`.
#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <vector>

#include "contact/detect/surface/point_reduction.h"
#include "tests/support/collision/pair_judge.h"

namespace nilas::pairs {

void PrintTo(const PairClass& c, std::ostream* out) { *out << c.name; }

namespace oracle_test {

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

/// Test names may contain letters, digits and underscores only.
std::string test_name(const testing::TestParamInfo<PairClass>& one) {
  std::string name = one.param.name;
  std::replace(name.begin(), name.end(), '-', 'm');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Pairs, OracleTest, testing::ValuesIn(all_classes()), test_name);

/// One plate lies a little above the other. Two edges cross well inside both, each on the far side of its plate: their
/// axis goes through both plates, six times as deep as the best.
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
  judge(known, 0, detect::ContactDetector().detect(known.bodies, 0), tally);
  EXPECT_EQ(tally.contacts, 1);
  EXPECT_EQ(tally.wrong_normals + tally.wrong_depths, 0) << tally.worst_depth;
}

/// Two bodies whose best direction is near a cylinder's axis, or among other maxima of nearly the same height.
struct NarrowTop {
  const char* name;
  geometry::Shape a, b;
  Quat q_a, q_b;
  Vec3 p_b;
  double gap;  ///< [m]
};

void PrintTo(const NarrowTop& top, std::ostream* out) { *out << top.name; }

class NarrowTopTest : public testing::TestWithParam<NarrowTop> {};

TEST_P(NarrowTopTest, IsFound) {
  const NarrowTop& top = GetParam();
  bodies::Bodies bodies;
  detect::add_body(bodies, top.a, Vec3::Zero(), top.q_a);
  detect::add_body(bodies, top.b, top.p_b, top.q_b);
  PairClass c{};
  c.size = 1;
  const KnownPair known = find_truth(c, std::move(bodies));
  EXPECT_NEAR(known.parts[0].gap.s, top.gap, k_right_depth);
  Tally tally;
  judge(known, 0, detect::ContactDetector().detect(known.bodies, 0), tally);
  EXPECT_EQ(tally.contacts, 1);
  EXPECT_EQ(tally.wrong_normals, 0);
  EXPECT_EQ(tally.wrong_depths, 0) << tally.worst_depth;
}

INSTANTIATE_TEST_SUITE_P(
    OfCylinders, NarrowTopTest,
    testing::Values(
        NarrowTop{"rim_along_an_edge",
                  geometry::cylinder_shape(0x1.006eaf6bfa056p-2, 0x1.60508ee8878ccp-2),
                  geometry::box_shape({0x1.512815da76b76p-1, 0x1.f80109361afcp-1, 0x1.e8659a90e50a2p-1}),
                  Quat(0.82221897576009317, -0.2891351464640326, 0.47965985392076455, -0.10140634849927574),
                  Quat(-0.59217857118666994, -0.50923637985773984, 0.56279603545394041, 0.27067225889260393),
                  {-0.57759576660450518, -0.34645459432184894, -0.35543889214956137},
                  -0.0046146083832327711},
        NarrowTop{"rims_16_and_6_degrees_from_their_axes",
                  geometry::cylinder_shape(0x1.340e1d17b9a67p-3, 0x1.4ab6a0351c3e9p-1),
                  geometry::cylinder_shape(0x1.cd1924be52365p-3, 0x1.870f03733b97cp-1),
                  Quat(0.2586870146204821, -0.70221311118417995, -0.12028879214345789, -0.65231003474762306),
                  Quat(0.68718980290709875, -0.32158242059154241, 0.64778620402824072, -0.068760129564085296),
                  {0.78886776630818112, -0.034548172972779893, -0.004461485634464483},
                  -0.001959329105991503},
        NarrowTop{"rim_and_rim_rather_than_side",
                  geometry::cylinder_shape(0x1.59c7b812c2b8dp-3, 0x1.a45349c9fb3bp-3),
                  geometry::cylinder_shape(0x1.258d369833662p-3, 0x1.8b40712f3fa7p-2),
                  Quat(0.37524372758571123, -0.60207497829764089, 0.0023680691680825596, -0.70476397301784033),
                  Quat(-0.025278226835644159, -0.86650355259855261, -0.32986242078031791, -0.37379590867455065),
                  {0.24845180155907612, 0.14897985154321977, 0.14638559397709125},
                  -9.1200962388543472e-05},
        NarrowTop{"rims_next_to_a_cap",
                  geometry::cylinder_shape(0x1.4ed9f57f2423cp-2, 0x1.7682783a88cep-2),
                  geometry::cylinder_shape(0x1.b6cc86b61ad1p-2, 0x1.a3927071fc30cp-1),
                  Quat(-0.75824765353377821, 0.2210351984291565, -0.057814172718445231, 0.61062382724455222),
                  Quat(0.18194269713119535, -0.25316569095949182, -0.38622226312310293, 0.86812231358818204),
                  {-0.24190173182241398, -0.15735358361809543, -0.60385917902507058},
                  -0.00010115554837938912}),
    [](const testing::TestParamInfo<NarrowTop>& one) { return one.param.name; });

struct PosedFloe {
  std::vector<Vec2> outline;
  double thickness;
  Vec3 p;
  std::array<double, 4> q;  ///< w, x, y, z
};

struct RememberedPair {
  const char* name;
  PosedFloe a, b;
  Vec3 p_earlier;  ///< Position of B at the earlier call.
  std::array<double, 4> q_earlier;
  double margin_earlier, s;
};

/// Pairs whose deepest corner was not among the four kept from the earlier pose. The depth found was too small by 6e-5,
/// 2e-6 and 6e-7 of the size.
const std::vector<RememberedPair> k_remembered_pairs{
    {"Deep",
     {{{0.9460727849313582, -0.295584148057528},
       {0.01779192170508503, 1.0319251963722753},
       {-0.9944646384560667, 0.12430174622432366},
       {0.08876022003139762, -0.9641039109890293}},
      0.3,
      {0, -0, 0},
      {0.35997569259186124, -0.5174145637393064, 0.59789906939736, -0.4951932681158377}},
     {{{0.9923397019313582, 0.0761665553615877},
       {0.8169446629251511, 0.5743701037067819},
       {0.3000868301118479, 0.9572658404617921},
       {-0.7346466579560947, 0.6889368157820083},
       {-0.999690344516011, 0.10907957122098452},
       {-0.8203683406926323, -0.5741354292955339},
       {0.013582901334180988, -0.9948441862155515},
       {0.6459118396260023, -0.7540666901347794}},
      0.3,
      {0.1157160140873004, -0.2648827387142187, 0.06216406917567207},
      {-0.4648148279000151, -0.6344699434047548, -0.47388458865701866, -0.39601573619442804}},
     {0.11524518094222834, -0.26555767420035287, 0.0621444916860419},
     {-0.4643641115891473, -0.6359294074556802, -0.47241303008751756, -0.39596172744928243},
     0.001104565507093656,
     -0.15457209864508786},
    {"ThinPlates",
     {{{0.9963410428894485, 0.1824041787716612},
       {0.7539830212654893, 0.6769043568603729},
       {-0.2743889900236993, 0.9647107214109474},
       {-0.8220781299322397, 0.558339914406846},
       {-0.9731429120982058, -0.16561779363922277},
       {-0.6127148863098127, -0.7743428862313407},
       {-0.0928735189018633, -0.987920374374554},
       {0.8202769220160223, -0.5821199635767097}},
      0.01,
      {0, -0, 0},
      {0.4540675170676263, -1.796312234219164e-05, 0.00016503810153857738, 0.8909672622401972}},
     {{{0.857857094131109, 0.1758734878539936},
       {0.37260971872508486, 0.8987208704647099},
       {-1.1283015452787948, -0.053191071865727774},
       {0.19163518489500286, -0.9105827020855456}},
      0.01,
      {-0.06994258364434634, -0.18874163662633284, 0.005497263245992756},
      {0.9990662519421069, -9.28229903000677e-05, 9.261945815417659e-05, 0.043204247891603376}},
     {-0.06994121410280023, -0.18872990929214845, 0.005494874250636442},
     {0.9990656050720046, -9.513557055081852e-05, 8.66852891648801e-05, 0.04321921097143368},
     0.00050896536540535,
     -0.004671432125571095},
    {"NeedleOnAFloe",
     {{{-0.7754205834935538, -4.339994933873338e-05},
       {1.224579416506446, -8.914768470078206e-06},
       {-0.4491588330128925, 5.2314717808811584e-05}},
      0.006258717325733253,
      {0, -0, 0},
      {0.9997364806785111, 9.583902033813545e-05, 0.0001659846481996084, 0.022955009573595732}},
     {{{0.9576954369695854, -0.26872102314556023},
       {0.700774969133937, 0.7054438870701492},
       {-0.07480416580556815, 0.9956999208977604},
       {-0.3499780898482717, 0.9370653077803549},
       {-0.92823998695769, 0.38482703570066007},
       {-1.0018142157683751, -0.09398829218879354},
       {-0.2752863946649446, -0.9650113834778948},
       {0.25768181194719775, -0.9665276737534668},
       {0.653562437361522, -0.7535313747429278}},
      0.3,
      {0.2150877444595585, -0.09753466402592766, -0.15382944782258204},
      {0.9945044349730384, 0.0039047032008633943, -6.60224325428487e-05, 0.1046215931484}},
     {0.21510374747384922, -0.0975261721619854, -0.1538210517803179},
     {0.9945037677033415, 0.003906098869535433, -7.179799276045363e-05, 0.10462787993899163},
     0.0005116331999590857,
     -0.0002114362723287565}};

TEST(RememberedPairs, KeepTheDeepestCorner) {
  const auto quat = [](const std::array<double, 4>& q) { return Quat(q[0], q[1], q[2], q[3]); };
  for (const RememberedPair& pair : k_remembered_pairs) {
    SCOPED_TRACE(pair.name);
    bodies::Bodies bodies;
    for (const PosedFloe& floe : {pair.a, pair.b})
      detect::add_body(bodies, detect::floe_shape(floe.outline, floe.thickness), floe.p, quat(floe.q));
    bodies::Bodies earlier = bodies;
    earlier.set_pose(1, pair.p_earlier, quat(pair.q_earlier));
    detect::ContactDetector detector;
    detector.detect(earlier, pair.margin_earlier);
    const auto points = detector.detect(bodies, k_margin);
    EXPECT_GT(points.size(), detect::k_spread_points);
    ASSERT_FALSE(points.empty());
    EXPECT_NEAR(oracle::best_axis(oracle::posed(bodies, 0), oracle::posed(bodies, 1)).s, pair.s, 1e-14);
    EXPECT_NEAR(deepest_point(points)->gap, pair.s, k_right_depth);
  }
}

// The oracle itself, where the answer is known.

TEST(Oracle, DepthOfABoxInABoxAndOfACylinderInABox) {
  bodies::Bodies bodies;
  detect::add_body(bodies, geometry::box_shape({2, 2, 1}), {0, 0, 0});
  detect::add_body(bodies, geometry::box_shape({1, 1, 1}), {0.2, 0.1, 0.9});
  detect::add_body(bodies, geometry::cylinder_shape(0.5, 2), {0, 1.4, 0.2},
                   Quat(Eigen::AngleAxisd(k_pi / 2, Vec3::UnitX())));
  const auto solid = [&](int b) { return oracle::posed(bodies, b); };
  const auto boxes = oracle::true_gap(solid(0), solid(1));
  EXPECT_NEAR(boxes.s, -0.1, 1e-15);
  EXPECT_NEAR((boxes.n - Vec3::UnitZ()).norm(), 0, 1e-15);
  EXPECT_NEAR(oracle::true_gap(solid(0), solid(2)).s, -0.6, 1e-15);
  EXPECT_NEAR(oracle::true_gap(solid(1), solid(0)).s, -0.1, 1e-15);
}

TEST(Oracle, DistanceOfVertexEdgeAndRim) {
  bodies::Bodies bodies;
  detect::add_body(bodies, geometry::box_shape({2, 2, 2}), {0, 0, 0});
  detect::add_body(bodies, geometry::box_shape({2, 2, 2}), {2.3, 2.4, 0.5});
  detect::add_body(bodies, geometry::cylinder_shape(1, 2), {2.3, 0, 2.4});
  const auto solid = [&](int b) { return oracle::posed(bodies, b); };
  const auto edges = oracle::true_gap(solid(0), solid(1)), rim = oracle::true_gap(solid(0), solid(2));
  EXPECT_NEAR(edges.s, 0.5, 1e-15);
  EXPECT_NEAR((edges.n - Vec3(0.6, 0.8, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR(rim.s, 0.5, 1e-15);
  EXPECT_NEAR((rim.n - Vec3(0.6, 0, 0.8)).norm(), 0, 1e-7);
}

TEST(Oracle, DistanceOfTwoRims) {
  bodies::Bodies bodies;
  detect::add_body(bodies, geometry::cylinder_shape(1, 2), {0, 0, 0});
  detect::add_body(bodies, geometry::cylinder_shape(2, 2), {3 + 0.3, 0, 2.4});
  const auto gap = oracle::true_gap(oracle::posed(bodies, 0), oracle::posed(bodies, 1));
  EXPECT_NEAR(gap.s, 0.5, 1e-15);
  EXPECT_NEAR((gap.n - Vec3(0.6, 0, 0.8)).norm(), 0, 1e-7);
}

}  // namespace oracle_test
}  // namespace nilas::pairs
