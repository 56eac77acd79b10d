#include "core/vessel/mooring/catenary.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "core/base/error.h"
#include "core/vessel/mooring/mooring_model.h"

namespace nilas::vessel {

namespace catenary_test {

/// The cases of MoorPy's tests/test_catenary.py. A C_B below 0 stands there for the height of the anchor above the bed.
struct Published {
  CatenaryLine line;
  CatenarySpan span;
  double anchor_across, anchor_up, fairlead_across, fairlead_down, on_bed;
};
const std::array<Published, 6> k_published{{
    {{500, 800, 7.51e12, 5}, {400, 200, 0.0}, 0, 0, 96643.43501616362, 237751.75997440016, 202.81030003199982},
    {{500, 800, 7.51e12, 0},
     {400, 200, 0.0},
     96643.42815934008,
     0,
     96643.42815934008,
     237751.75535996316,
     202.81030580004602},
    {{500, 800, 7.51e12, 0.1},
     {400, 200, 0.0},
     80418.60434855078,
     0,
     96643.42877136687,
     237751.75577183915,
     202.81030528520108},
    {{500, 200, 7.51e12, 0},
     {400, 200, 372.7},
     43694.580989249596,
     -22365.599350216216,
     43694.580989249596,
     77634.40064978378,
     0},
    {{130, 881.05, 7.51e8, 0},
     {89.9, 59.2, 372.7},
     31373.229006023103,
     -26650.341270116318,
     31373.229006023103,
     87886.15872988368,
     0},
    {{100, -881.0549577007893, 7.51e8, 0},
     {37.96888656874307, 20.49078283711694, 1245.2679469540894},
     6428.437434537766,
     53178.729367882406,
     6428.437434537766,
     -34926.76640219652,
     0},
}};

TEST(Catenary, GivesThePublishedForces) {
  for (std::size_t k = 0; k < k_published.size(); ++k) {
    const Published& known = k_published[k];
    const CatenaryForces found = solve_catenary(known.line, known.span);
    // MoorPy's own tolerance is 1e-6 m of the ends, so its forces are exact to about 1e-7.
    const auto near = [&](double value, double expected, const char* what) {
      EXPECT_NEAR(value, expected, 1e-6 * std::abs(expected)) << what << " of case " << k;
    };
    near(found.anchor_across, known.anchor_across, "anchor_across");
    near(found.anchor_up, known.anchor_up, "anchor_up");
    near(found.fairlead_across, known.fairlead_across, "fairlead_across");
    near(found.fairlead_down, known.fairlead_down, "fairlead_down");
    near(found.on_bed, known.on_bed, "on_bed");
  }
}

/// A chain of 0.252 m and 390 kg/m, at the places of MoorDyn's tests/quasi_static_chain.cpp [m, N].
struct Chain {
  double depth, span, length;
  double moordyn_fairlead, moordyn_anchor;      ///< MoorDyn 2.7.2 at rest, first and last node
  double published_fairlead, published_anchor;  ///< quasi-static codes, as that test states them
};
constexpr std::array<Chain, 3> k_chains{{{50, 400, 410, 1001.16e3, 839.59e3, 991.6e3, 826.2e3},
                                         {200, 700, 760, 2060.70e3, 1408.04e3, 2065.4e3, 1402.2e3},
                                         {600, 1500, 1700, 5225.12e3, 3249.37e3, 5232.6e3, 3244.2e3}}};

/// In 50 m the chain is nearly straight: a depth that is less by half its diameter lowers the anchor's tension by
/// 0.75 %. A line with its diameter lies on its underside, and meets the published tensions. Without one its axis lies
/// on the bed, as in MoorDyn, and it meets those of MoorDyn at rest.
TEST(Catenary, GivesTheTensionsOfChains) {
  constexpr double k_diameter = 0.252, k_weight = (390 - 1025 * k_pi / 4 * k_diameter * k_diameter) * 9.81;
  for (const Chain& chain : k_chains) {
    const auto tensions = [&](double diameter) {
      MooringLine line;
      line.anchor = {chain.span, 0, -chain.depth};
      line.form = CatenaryLine{chain.length, k_weight, 1.674e9, 0, diameter};
      return line_force(line, -chain.depth, Vec3::Zero());
    };
    const LineForce thin = tensions(0), thick = tensions(k_diameter);
    EXPECT_NEAR(thin.fairlead_tension / chain.moordyn_fairlead, 1, 0.01) << chain.depth;
    EXPECT_NEAR(thin.anchor_tension / chain.moordyn_anchor, 1, 0.01) << chain.depth;
    EXPECT_NEAR(thick.fairlead_tension / chain.published_fairlead, 1, 0.01) << chain.depth;
    EXPECT_NEAR(thick.anchor_tension / chain.published_anchor, 1, 0.01) << chain.depth;
  }
}

/// The place of the fairlead by a sum of short pieces from the anchor, which knows nothing of closed forms.
Vec2 marched(const CatenaryLine& line, const CatenaryForces& forces) {
  constexpr int k_pieces = 400000;
  const double piece = line.length / k_pieces;
  Vec2 end = Vec2::Zero();
  const double rising = forces.anchor_up < 0 ? -forces.anchor_up / line.weight : 0;  // unstretched length to the bed
  for (int k = 0; k < k_pieces; ++k) {
    const double s = (k + 0.5) * piece;
    double across = forces.fairlead_across, up = forces.anchor_up + line.weight * s;
    if (forces.on_bed > 0) {
      if (s > rising) up = std::max(0.0, line.weight * (s - rising - forces.on_bed));
      const double gripped = line.weight * line.bed_friction * std::max(0.0, rising + forces.on_bed - s);
      if (forces.anchor_up == 0) across = std::max(0.0, across - gripped);
    }
    const double tension = std::hypot(across, up);
    const Vec2 along = tension > 0 ? Vec2(across, up) / tension : Vec2(1, 0);
    end += piece * (1 + tension / line.stiffness) * along;
  }
  return end;
}

struct Case {
  const char* what;
  CatenaryLine line;
  CatenarySpan span;
};
const std::vector<Case> k_cases{
    {"on the bed", {500, 800, 7.51e8, 0}, {400, 200, 0.0}},
    {"on the bed with friction", {500, 800, 7.51e7, 0.1}, {420, 150, 0.0}},
    {"friction takes all tension", {500, 800, 7.51e7, 5}, {400, 200, 0.0}},
    {"off the bed", {500, 200, 7.51e8, 0}, {400, 200, std::nullopt}},
    {"fairlead below the anchor", {500, 200, 7.51e8, 0}, {400, -200, 900.0}},
    {"sags onto the bed", {500, 800, 7.51e8, 0}, {400, 100, 20.0}},
    {"sags onto the bed, fairlead lower", {500, 800, 7.51e8, 0}, {440, -30, 50.0}},
    {"nearly straight", {447, 200, 7.51e8, 0}, {400, 200, 0.0}},
    {"stretched", {440, 200, 1e8, 0}, {400, 200, 0.0}},
    {"stretched rope of little weight", {440, 0.1, 1e8, 0}, {400, 200, 0.0}},
    {"lifts off the bed", {450, 200, 7.51e8, 0}, {400, 200, 0.0}},
    {"steep", {200.5, 800, 7.51e8, 0}, {1, 200, 0.0}},
    {"hangs in a loop", {500, 800, 7.51e8, 0}, {10, 20, std::nullopt}},
    {"flat on the bed", {500, 800, 7.51e7, 0}, {501, 0, 0.0}},
    {"flat on the bed with friction", {500, 800, 7.51e7, 0.3}, {501, 0, 0.0}},
};

TEST(Catenary, ReachesItsFairlead) {
  for (const Case& c : k_cases) {
    const Vec2 end = marched(c.line, solve_catenary(c.line, c.span));
    // The midpoint sum leaves the square of a piece of 1 mm, and one piece where the line leaves the bed.
    EXPECT_NEAR(end.x(), c.span.across, 2e-6) << c.what;
    EXPECT_NEAR(end.y(), c.span.up, 2e-6) << c.what;
  }
}

TEST(Catenary, HasTheStiffnessOfItsForces) {
  for (const Case& c : k_cases) {
    if (c.span.above_bed && *c.span.above_bed + c.span.up == 0) continue;  // no fairlead may sink into the bed
    const CatenaryForces here = solve_catenary(c.line, c.span);
    constexpr double k_move = 1e-4;  // [m]
    for (int axis = 0; axis < 2; ++axis) {
      CatenarySpan more = c.span, less = c.span;
      (axis == 0 ? more.across : more.up) += k_move;
      (axis == 0 ? less.across : less.up) -= k_move;
      const CatenaryForces a = solve_catenary(c.line, more), b = solve_catenary(c.line, less);
      const Vec2 slope = Vec2(a.fairlead_across - b.fairlead_across, a.fairlead_down - b.fairlead_down) / (2 * k_move);
      EXPECT_LT((slope - here.stiffness.col(axis)).norm(), 1e-5 * here.stiffness.norm()) << c.what << ", " << axis;
    }
  }
}

/// A line of 500 m in a depth of 100 m needs 100 m to hang. The rest reaches 400 m, so that H is 0 up to there.
TEST(Catenary, HangsSlackWhereItHasLengthToSpare) {
  const CatenaryLine chain{500, 800, 1e30, 0.5};
  for (const double across : {0.0, 100.0, 399.999}) {
    const CatenaryForces found = solve_catenary(chain, {across, 100, 0.0});
    EXPECT_TRUE(found.slack);
    EXPECT_EQ(found.fairlead_across, 0);
    EXPECT_DOUBLE_EQ(found.fairlead_down, 800 * 100);
    EXPECT_DOUBLE_EQ(found.on_bed, 400);
    EXPECT_DOUBLE_EQ(found.stiffness(1, 1), 800);
  }
  const CatenaryForces tight = solve_catenary(chain, {400.001, 100, 0.0});
  EXPECT_FALSE(tight.slack);
  EXPECT_GT(tight.fairlead_across, 0);
  // From an anchor 30 m above the bed, 130 m hang.
  const CatenaryForces above = solve_catenary(chain, {300, 100, 30.0});
  EXPECT_TRUE(above.slack);
  EXPECT_DOUBLE_EQ(above.on_bed, 500 - 130 - 30);
  EXPECT_DOUBLE_EQ(above.anchor_up, -800 * 30);
}

/// A plumb line that is too short: stretch = (V L - w L^2/2)/EA.
TEST(Catenary, HangsPlumb) {
  const CatenaryLine rope{95, 50, 1e6, 0};
  const CatenaryForces found = solve_catenary(rope, {0, 100, 0.0});
  EXPECT_EQ(found.fairlead_across, 0);
  EXPECT_NEAR(found.fairlead_down, (5 * 1e6 + 50 * 95 * 95 / 2.0) / 95, 1e-6);
  // A pendulum's stiffness is the limit of small distances from the plumb.
  const CatenaryForces aside = solve_catenary(rope, {1e-4, 100, 0.0});
  EXPECT_NEAR(aside.fairlead_across / 1e-4, found.stiffness(0, 0), 1e-6 * found.stiffness(0, 0));
  // A loop in deep water hangs on both ends: V - V_A = w L, and the lengths of both sides differ by the height.
  const CatenaryForces loop = solve_catenary({95, 50, 1e30, 0}, {0, 20, std::nullopt});
  EXPECT_DOUBLE_EQ(loop.fairlead_down, 50 * (95 + 20) / 2.0);
  EXPECT_DOUBLE_EQ(loop.anchor_up, -50 * (95 - 20) / 2.0);
}

TEST(Catenary, TreatsABuoyantLineAsAMirrorImage) {
  const CatenaryForces heavy = solve_catenary({300, 500, 1e9, 0}, {200, 120, std::nullopt});
  const CatenaryForces buoyant = solve_catenary({300, -500, 1e9, 0}, {200, -120, std::nullopt});
  EXPECT_EQ(heavy.fairlead_across, buoyant.fairlead_across);
  EXPECT_EQ(heavy.fairlead_down, -buoyant.fairlead_down);
  EXPECT_EQ(heavy.anchor_up, -buoyant.anchor_up);
  // Exchanged ends: the anchor of one line is the fairlead of the other.
  const CatenaryForces turned = solve_catenary({300, 500, 1e9, 0}, {200, -120, std::nullopt});
  EXPECT_NEAR(turned.fairlead_across, heavy.fairlead_across, 1e-11 * heavy.fairlead_across);
  EXPECT_NEAR(turned.fairlead_down, -heavy.anchor_up, 1e-11 * heavy.fairlead_down);
}

/// From slack to far beyond the line's strength, and over all heights, the search ends and H rises with the distance.
TEST(Catenary, EndsEverySearch) {
  for (const double EA : {1e5, 1e8, 1e12})
    for (const double w : {0.01, 50.0, 5000.0})
      for (const double up : {0.0, 1e-6, 1.0, 99.0, 300.0, 900.0})
        for (const double friction : {0.0, 0.3, 5.0}) {
          double last = 0;
          for (double across = 0; across < 1200; across += 7.3) {
            const CatenaryForces found = solve_catenary({500, w, EA, friction}, {across, up, 0.0});
            ASSERT_TRUE(std::isfinite(found.fairlead_tension())) << EA << ' ' << w << ' ' << up << ' ' << across;
            ASSERT_GE(found.fairlead_across, last * (1 - 1e-9)) << EA << ' ' << w << ' ' << up << ' ' << across;
            last = found.fairlead_across;
          }
        }
}

TEST(Catenary, RefusesWhatIsNoLine) {
  EXPECT_THROW(solve_catenary({0, 1, 1, 0}, {1, 1, std::nullopt}), ContractError);
  EXPECT_THROW(solve_catenary({1, 0, 1, 0}, {1, 1, std::nullopt}), ContractError);
  EXPECT_THROW(solve_catenary({1, 1, 1, 0}, {1, -1, 0.0}), ContractError);
}

}  // namespace catenary_test

}  // namespace nilas::vessel
