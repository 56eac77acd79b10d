/// The concentrations that packed fields reach, over shapes, size distributions and seeds; overlaps are searched for
/// independently of the packing.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/field/field.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/polygon.h"
#include "tests/core/field/field_measures.h"

namespace nilas::field {
namespace dense_packing_test {

void expect_packed(const PackedSpec& spec, const FieldResult& field, double largest) {
  const double region = (spec.high - spec.low).prod();
  const double ice = test::ice_area(field);
  test::expect_inside(spec, field);
  EXPECT_NEAR(ice / region, field.concentration, 1e-12);
  EXPECT_NEAR(ice / region, spec.concentration, 0.5 * largest * largest / region);
  EXPECT_EQ(field.worst_overlap, 0);
  EXPECT_LT(test::deepest_overlap(field), 0);
}

struct Case {
  SizeDistribution distribution;
  double width;  ///< Width of the region for about 120 floes [m].
};

class DensePolygons : public testing::TestWithParam<Case> {};

TEST_P(DensePolygons, ReachNinetyFivePercentWithoutOverlap) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    PackedSpec spec;
    spec.distribution = GetParam().distribution;
    spec.high = {1.5 * GetParam().width, GetParam().width};
    spec.concentration = 0.95;
    spec.overlap_tolerance = 0;
    spec.seed = seed;
    const FieldResult field = pack_field(spec);
    EXPECT_GT(field.floes.size(), 90u);
    expect_packed(spec, field, spec.distribution == SizeDistribution::fixed ? spec.mean : spec.max);
  }
}

INSTANTIATE_TEST_SUITE_P(Distributions, DensePolygons,
                         testing::Values(Case{SizeDistribution::lognormal, 7.8}, Case{SizeDistribution::power_law, 5.6},
                                         Case{SizeDistribution::uniform, 9.4}, Case{SizeDistribution::fixed, 7.4}));

/// 9.9 m squares in a square of 30 times 10 m by as much, a shipped case of IceFieldCreator, at a third of its sides.
TEST(DenseSquares, ReachNinetyEightPercent) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    PackedSpec spec;
    spec.high = {100, 100};
    spec.concentration = 0.98;
    spec.overlap_tolerance = 0;
    spec.shape = FloeShape::square;
    spec.distribution = SizeDistribution::fixed;
    spec.mean = 9.9;
    spec.seed = seed;
    const FieldResult field = pack_field(spec);
    EXPECT_EQ(field.floes.size(), 100u);
    expect_packed(spec, field, spec.mean);
  }
}

TEST(DenseSquares, LieInRowsBesideAHull) {
  PackedSpec spec;
  spec.high = {16.16, 10.1};
  spec.concentration = 0.94;
  spec.shape = FloeShape::square;
  spec.distribution = SizeDistribution::fixed;
  spec.mean = 1;
  spec.keep_out = {{{0, 4.1}, {5, 4.1}, {5, 6}, {0, 6}}};
  const FieldResult field = pack_field(spec);
  EXPECT_LT(test::deepest_overlap(field), 0);
  EXPECT_GT(field.concentration, 0.935);
  for (const auto& floe : field.floes) EXPECT_LE(geometry::convex_overlap(spec.keep_out[0], floe.outline), 0);
}

TEST(DenseRectangles, ReachNinetySixPercentInRows) {
  PackedSpec spec;
  spec.high = {18.3, 12.2};
  spec.concentration = 0.96;
  spec.shape = FloeShape::rectangle;
  spec.distribution = SizeDistribution::fixed;
  spec.aspect = 1.5;
  spec.mean = std::sqrt(1.5);
  const FieldResult field = pack_field(spec);
  expect_packed(spec, field, spec.mean);
}

PackedSpec library_spec(double concentration) {
  PackedSpec spec;
  spec.high = {14, 10};
  spec.concentration = concentration;
  spec.shape = FloeShape::library;
  spec.library = {{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  return spec;
}

TEST(Library, ScalesOutlinesToTheSizesAndCountsTheTrueArea) {
  const PackedSpec spec = library_spec(0.55);
  const FieldResult field = pack_field(spec);
  double ice = 0;
  std::size_t concave = 0;
  for (const auto& floe : field.floes) {
    const double area = geometry::polygon_moments(floe.outline).area;
    ice += area;
    EXPECT_GE(std::sqrt(area), spec.min * (1 - 1e-12));
    EXPECT_LE(std::sqrt(area), spec.max * (1 + 1e-12));
    if (!geometry::is_convex(floe.outline)) ++concave;
  }
  EXPECT_NEAR(ice / 140, field.concentration, 1e-12);
  EXPECT_NEAR(ice / 140, 0.55, 0.5 * spec.max * spec.max / 140);
  EXPECT_GT(concave, field.floes.size() / 4);
  EXPECT_LT(concave, field.floes.size());
  for (std::size_t i = 0; i < field.floes.size(); ++i)
    for (std::size_t j = i + 1; j < field.floes.size(); ++j)
      EXPECT_LT(geometry::convex_overlap(geometry::convex_hull(field.floes[i].outline),
                                         geometry::convex_hull(field.floes[j].outline)),
                0);
}

TEST(Library, AsLibraryKeepsTheOutlinesSizes) {
  PackedSpec spec = library_spec(0.5);
  spec.distribution = SizeDistribution::as_library;
  for (const auto& floe : pack_field(spec).floes)
    EXPECT_NEAR(geometry::polygon_moments(floe.outline).area, floe.outline.size() == 6 ? 4 : 1, 1e-12);
}

TEST(Library, AsLibraryWithoutOneIsRefused) {
  PackedSpec spec;
  spec.distribution = SizeDistribution::as_library;
  EXPECT_THROW(pack_field(spec), InputError);
  spec.shape = FloeShape::library;
  EXPECT_THROW(pack_field(spec), InputError);
}

}  // namespace dense_packing_test
}  // namespace nilas::field
