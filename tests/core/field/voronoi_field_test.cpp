#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/field/field.h"
#include "core/field/shapes/power_diagram.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/polygon.h"
#include "tests/core/field/field_measures.h"
#include "tests/support/refusal.h"

namespace nilas::field {
namespace voronoi_field_test {

PackedSpec spec_of(double concentration, std::uint64_t seed) {
  PackedSpec spec;
  spec.low = {-3, 2};
  spec.high = {15, 12};
  spec.concentration = concentration;
  spec.seed = seed;
  return spec;
}

std::vector<double> sizes(const FieldResult& field) {
  std::vector<double> found;
  for (const auto& floe : field.floes) found.push_back(std::sqrt(geometry::polygon_moments(floe.outline).area));
  std::sort(found.begin(), found.end());
  return found;
}

class Voronoi : public testing::TestWithParam<SizeDistribution> {};

/// Sizes are those drawn, up to the one factor that meets the concentration: packed fields draw the same ones.
TEST_P(Voronoi, AreasFollowTheDistributionAndTheConcentrationIsExact) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    auto spec = spec_of(0.6, seed);
    spec.distribution = GetParam();
    const std::vector<double> drawn = sizes(pack_field(spec));
    const FieldResult field = voronoi_field(spec);
    EXPECT_NEAR(field.concentration, 0.6, 1e-9);
    EXPECT_LT(test::deepest_overlap(field), 0);
    const std::vector<double> found = sizes(field);
    ASSERT_EQ(found.size(), drawn.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i] / drawn[i], found[0] / drawn[0], 1e-7);
    for (const auto& floe : field.floes) EXPECT_TRUE(geometry::is_convex(floe.outline));
  }
}

INSTANTIATE_TEST_SUITE_P(Distributions, Voronoi,
                         testing::Values(SizeDistribution::fixed, SizeDistribution::uniform,
                                         SizeDistribution::lognormal, SizeDistribution::power_law));

TEST(Voronoi, AtHundredPercentCellsShareTheirEdges) {
  const auto spec = spec_of(1, 4);
  const FieldResult field = voronoi_field(spec);
  EXPECT_NEAR(field.concentration, 1, 1e-9);
  const double touching = test::deepest_overlap(field);
  EXPECT_LT(touching, 1e-9);
  EXPECT_GT(touching, -1e-9);
}

/// One sheet; each cell's perimeter is seams, shared by two, and the region's edge.
TEST(Voronoi, FrozenFloesAreASheetWithSeams) {
  const PackedSpec spec = spec_of(0.3, 4);
  PackedSpec full = spec;
  full.concentration = 1;
  const FieldResult cells = voronoi_field(full), frozen = frozen_field(spec, -Vec2::UnitX(), 0.4);
  ASSERT_EQ(frozen.floes.size(), 1u);
  EXPECT_NEAR(geometry::polygon_moments(frozen.floes[0].outline).area, 180, 1e-9);
  double perimeters = 0, seams = 0;
  for (const FieldFloe& cell : cells.floes)
    for (std::size_t i = 0; i < cell.outline.size(); ++i)
      perimeters += (cell.outline[(i + 1) % cell.outline.size()] - cell.outline[i]).norm();
  for (const bodies::WeakLine& line : frozen.weak_lines) {
    ASSERT_EQ(line.points.size(), 2u);
    EXPECT_EQ(line.strength, 0.4);
    seams += (line.points[1] - line.points[0]).norm();
  }
  EXPECT_NEAR(2 * seams, perimeters - 2 * (18 + 10), 1e-4 * perimeters) << "cells are made smaller by rounding";
  EXPECT_TRUE(cells.weak_lines.empty());
}

TEST(Voronoi, SameSeedSameBits) {
  const FieldResult one = voronoi_field(spec_of(0.9, 5)), two = voronoi_field(spec_of(0.9, 5));
  ASSERT_EQ(one.floes.size(), two.floes.size());
  for (std::size_t i = 0; i < one.floes.size(); ++i) EXPECT_EQ(one.floes[i].outline, two.floes[i].outline);
  EXPECT_NE(one.floes[0].outline, voronoi_field(spec_of(0.9, 6)).floes[0].outline);
}

TEST(Voronoi, KeepsClearOfAHullOutlineAndSaysWhatFits) {
  auto spec = spec_of(0.95, 7);
  spec.keep_out = {{{2, 6.4}, {6, 6.4}, {8, 7}, {6, 7.6}, {2, 7.6}}};
  spec.keep_out_margin = 0.05;
  const FieldResult field = voronoi_field(spec);
  EXPECT_NEAR(field.concentration, 0.95, 1e-9);
  for (const auto& floe : field.floes) EXPECT_LT(geometry::convex_overlap(spec.keep_out[0], floe.outline), -0.049);
  spec.concentration = 1;
  test::expect_refusal([&] { voronoi_field(spec); }, {"leave room for about 0.9"});
}

/// Two sites 2 apart in a 4 x 1 strip: the border lies at (w1 - w2) / (2 d) from the middle.
TEST(PowerDiagram, BorderShiftsWithTheWeights) {
  FieldBounds bounds{{0, 0}, {4, 1}, {}};
  const auto cells = power_cells({{{1, 0.5}, {3, 0.5}}, {1.2, 0.4}}, bounds);
  EXPECT_NEAR(cells[0].area, 2 + 0.8 / 4, 1e-14);
  EXPECT_NEAR(cells[1].area, 2 - 0.8 / 4, 1e-14);
}

TEST(PowerDiagram, ASiteOutweighedHasNoCell) {
  FieldBounds bounds{{0, 0}, {4, 1}, {}};
  const auto cells = power_cells({{{1, 0.5}, {2, 0.5}, {3, 0.5}}, {9, 0, 9}}, bounds);
  EXPECT_EQ(cells[1].area, 0);
  EXPECT_NEAR(cells[0].area + cells[2].area, 4, 1e-14);
}

}  // namespace voronoi_field_test
}  // namespace nilas::field
