#include "core/field/pack/relaxation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"
#include "core/field/pack/exchange.h"
#include "core/field/pack/fitting.h"
#include "core/field/pack/overlaps.h"
#include "core/field/pack/place_floes.h"
#include "core/geometry/mass_properties.h"

namespace nilas::field {
namespace relaxation_test {

LooseFloe box(double x0, double y0, double x1, double y1) {
  return loose_floe({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}
FieldBounds region(double length, double width) { return {{0, 0}, {length, width}, {}}; }

/// Faces overlap by 0.1 at two points, symmetric about the centres: no turn, and each floe gives way as the other's
/// mass.
TEST(Relaxation, FloesGiveWayInverselyToTheirMass) {
  std::vector<LooseFloe> floes{box(2, 2, 4, 4), box(3.9, 2.5, 4.9, 3.5)};
  const FieldBounds bounds = region(10, 6);
  Relaxation relaxation(floes, bounds, {0, 0.05, 100});
  EXPECT_NEAR(relaxation.pass(1, 0), 0.1, 1e-12);
  EXPECT_NEAR(floes[0].centre.x(), 3 - 0.1 * 1 / 5, 1e-9);
  EXPECT_NEAR(floes[1].centre.x(), 4.4 + 0.1 * 4 / 5, 1e-9);
  EXPECT_NEAR(floes[0].angle, 0, 1e-9);
  EXPECT_NEAR(floes[1].angle, 0, 1e-9);
  EXPECT_NEAR(relaxation.pass(1, 1e-9), 0, 1e-9);
}

/// A wall pushes a free square of side a off its centre. The gap is needed at one corner only, so the square turns and
/// moves.
TEST(Relaxation, AnEdgeCornerTurnsTheFloe) {
  std::vector<LooseFloe> floes{box(2, 0.1, 3, 1.1)};
  floes[0].angle = 20 * k_deg;
  const FieldBounds bounds = region(10, 6);
  Relaxation relaxation(floes, bounds, {0, 0.05, 100});
  double worst = 1;
  for (int k = 0; k < 50 && worst > 1e-9; ++k) worst = relaxation.pass(1, 1e-9);
  EXPECT_LE(worst, 1e-9);
  EXPECT_LT(floes[0].angle, 20 * k_deg);
  EXPECT_LE(deepest_overlap(floes, bounds), 1e-9);
}

TEST(Relaxation, AcceptedFieldIsNotMoved) {
  std::vector<LooseFloe> floes{box(1, 1, 2, 2), box(2.01, 1, 3, 2)};
  const FieldBounds bounds = region(10, 6);
  Relaxation relaxation(floes, bounds, {0.01, 0.05, 100});
  EXPECT_NEAR(relaxation.pass(1, 1e-9), 0, 1e-9);
  EXPECT_EQ(floes[0].centre, Vec2(1.5, 1.5));
}

/// An exchange never deepens the sum of overlaps: here the large floe goes where there is room for it.
TEST(Exchange, FloesFindRoom) {
  std::vector<LooseFloe> floes{box(0, 0, 2, 2), box(0, 0, 2, 2), box(0, 0, 1, 1)};
  floes[0].centre = {1.5, 1.5};
  floes[1].centre = {2.5, 1.5};
  floes[2].centre = {7, 1.5};
  const FieldBounds bounds = region(8, 3);
  const double before = deepest_overlap(floes, bounds);
  RandomStream random(1, "exchange");
  Exchange(floes, bounds, 0, random).run(2000);
  EXPECT_GT(before, 0.9);
  EXPECT_LT(deepest_overlap(floes, bounds), 0.3);
}

/// Two squares overlap by 0.2 with free water all around: fitted once they keep their areas and the gap between them.
TEST(Fitting, OverlapBecomesAGapAndAreasStay) {
  std::vector<LooseFloe> floes{box(2, 2, 4, 4), box(3.8, 2.5, 5.8, 4.5)};
  const FieldBounds bounds = region(10, 8);
  const auto changed = fit_outlines(floes, bounds, {0.01, 5, 7});
  EXPECT_EQ(changed.size(), 2u);
  const auto outlines = placed_outlines(floes);
  EXPECT_NEAR(best_axis(outlines[0], outlines[1]).gap, 0.01, 1e-3);
  for (const auto& outline : outlines) {
    EXPECT_NEAR(geometry::polygon_moments(outline.corners).area, 4, 1e-9);
    EXPECT_GE(outline.corners.size(), 5u);
    EXPECT_LE(outline.corners.size(), 7u);
  }
}

TEST(Fitting, FloesWithinTheirCellsKeepTheirOutlines) {
  std::vector<LooseFloe> floes{box(2, 2, 4, 4), box(4.1, 2.5, 5.8, 4.5)};
  const auto before = placed_outlines(floes);
  EXPECT_TRUE(fit_outlines(floes, region(10, 8), {0.01, 3, 9}).empty());
  EXPECT_EQ(placed_outlines(floes)[0].corners, before[0].corners);
}

TEST(NearPairs, FindsWhatAllPairsFind) {
  RandomStream random(5, "pairs");
  std::vector<LooseFloe> floes;
  for (int k = 0; k < 300; ++k) {
    const double x = random.uniform(0, 20), y = random.uniform(0, 10), side = random.uniform(0.1, 2);
    floes.push_back(box(x, y, x + side, y + side));
  }
  std::size_t all = 0;
  for (std::size_t i = 0; i < floes.size(); ++i)
    for (std::size_t j = i + 1; j < floes.size(); ++j)
      all += (floes[i].centre - floes[j].centre).norm() < floes[i].radius + floes[j].radius + 0.3;
  EXPECT_EQ(near_pairs(floes, 1, 0.3).size(), all);
}

}  // namespace relaxation_test
}  // namespace nilas::field
