#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/field/field.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/polygon.h"
#include "tests/core/field/field_measures.h"
#include "tests/support/mentions.h"
#include "tests/support/refusal.h"

namespace nilas::field {
namespace pack_field_test {

PackedSpec spec_of(double length, double width, double concentration, FloeShape shape = FloeShape::polygon) {
  PackedSpec spec;
  spec.low = {-2, 1};
  spec.high = spec.low + Vec2(length, width);
  spec.concentration = concentration;
  spec.shape = shape;
  return spec;
}

/// Largest separation over the edge normals of `a`, by plain search.
double separation(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 edge = a[(i + 1) % a.size()] - a[i];
    const Vec2 normal = Vec2(edge.y(), -edge.x()).normalized();
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec2& p : b) nearest = std::min(nearest, normal.dot(p - a[i]));
    best = std::max(best, nearest);
  }
  return best;
}

/// Smallest gap over all pairs, without any of the packing's own searches.
double smallest_gap(const std::vector<FieldFloe>& floes) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < floes.size(); ++i)
    for (std::size_t j = i + 1; j < floes.size(); ++j) {
      const auto &a = floes[i].outline, &b = floes[j].outline;
      smallest = std::min(smallest, std::max(separation(a, b), separation(b, a)));
    }
  return smallest;
}

/// The whole contract of a field without keep-out outlines.
void expect_good(const PackedSpec& spec, const FieldResult& field) {
  const double region = (spec.high - spec.low).prod();
  EXPECT_NEAR(test::ice_area(field) / region, field.concentration, 1e-12);
  const double largest = spec.distribution == SizeDistribution::fixed ? spec.mean : spec.max;
  EXPECT_NEAR(field.concentration, spec.concentration, 0.5 * largest * largest / region);
  EXPECT_EQ(field.worst_overlap, 0);
  EXPECT_GT(smallest_gap(field.floes), 0);
  EXPECT_EQ(field.left_out, 0);
  test::expect_inside(spec, field);
  for (const auto& floe : field.floes) {
    EXPECT_TRUE(geometry::is_convex(floe.outline));
    EXPECT_GT(geometry::polygon_moments(floe.outline).area, 0);
  }
}

bool same_bits(const FieldResult& a, const FieldResult& b) {
  if (a.floes.size() != b.floes.size()) return false;
  for (std::size_t i = 0; i < a.floes.size(); ++i)
    if (a.floes[i].outline != b.floes[i].outline) return false;
  return true;
}

TEST(PackField, TowingFieldAtEightyPercent) {
  const auto spec = spec_of(40, 10, 0.8);
  const auto field = pack_field(spec);
  EXPECT_EQ(field.fitted, 0);
  EXPECT_NEAR(static_cast<double>(field.floes.size()), 440, 60);
  expect_good(spec, field);
}

TEST(PackField, SameSeedSameBitsAnotherSeedAnotherField) {
  auto spec = spec_of(12, 8, 0.86);
  const auto field = pack_field(spec);
  EXPECT_TRUE(same_bits(field, pack_field(spec)));
  spec.seed = 2;
  EXPECT_FALSE(same_bits(field, pack_field(spec)));
}

class PackShape : public testing::TestWithParam<FloeShape> {};

TEST_P(PackShape, ReachesEightyFivePercent) {
  auto spec = spec_of(12, 8, 0.85, GetParam());
  spec.shear = 20 * k_deg;
  expect_good(spec, pack_field(spec));
}

INSTANTIATE_TEST_SUITE_P(Shapes, PackShape,
                         testing::Values(FloeShape::polygon, FloeShape::rectangle, FloeShape::square,
                                         FloeShape::parallelogram, FloeShape::disc));

TEST(PackField, PolygonsReachNinetyFivePercentWithTheirSizesAndCorners) {
  auto spec = spec_of(20, 12, 0.95);
  const auto field = pack_field(spec);
  expect_good(spec, field);
  EXPECT_GT(field.fitted, static_cast<int>(field.floes.size()) / 2);
  for (const auto& floe : field.floes) {
    const double size = std::sqrt(geometry::polygon_moments(floe.outline).area);
    EXPECT_GE(size, spec.min * (1 - 1e-12));
    EXPECT_LE(size, spec.max * (1 + 1e-12));
    EXPECT_GE(static_cast<int>(floe.outline.size()), spec.vertices_min);
    EXPECT_LE(static_cast<int>(floe.outline.size()), spec.vertices_max);
  }
}

TEST(PackField, SquaresReachNinetyPercent) {
  const auto spec = spec_of(16, 10, 0.9, FloeShape::square);
  expect_good(spec, pack_field(spec));
}

struct Moments {
  double mean = 0, sd = 0, smallest = 1e300, largest = 0;
};
Moments size_moments(const FieldResult& field) {
  Moments m;
  double squares = 0;
  for (const auto& floe : field.floes) {
    const double size = std::sqrt(geometry::polygon_moments(floe.outline).area);
    m.mean += size;
    squares += size * size;
    m.smallest = std::min(m.smallest, size);
    m.largest = std::max(m.largest, size);
  }
  const double n = static_cast<double>(field.floes.size());
  m.mean /= n;
  m.sd = std::sqrt(std::max(0.0, squares / n - m.mean * m.mean));
  return m;
}

/// The sample mean is within four standard errors of the requested one; the sample sd of about 1000 floes within 10 %.
TEST(PackField, SizesFollowTheAskedDistribution) {
  auto spec = spec_of(40, 18, 0.5);
  spec.min = 0.1;
  spec.max = 4;
  const auto expect_moments = [&](double mean, double sd) {
    const auto field = pack_field(spec);
    const Moments m = size_moments(field);
    EXPECT_NEAR(m.mean, mean, 4 * sd / std::sqrt(static_cast<double>(field.floes.size())));
    EXPECT_NEAR(m.sd, sd, 0.1 * sd);
  };
  expect_moments(spec.mean, spec.sd);
  spec.distribution = SizeDistribution::uniform;
  spec.min = 0.4;
  spec.max = 1.2;
  // The distribution is uniform between the ends, whatever mean and sd are.
  expect_moments(0.8, 0.8 / std::sqrt(12.0));
  spec.distribution = SizeDistribution::fixed;
  const Moments m = size_moments(pack_field(spec));
  EXPECT_NEAR(m.mean, spec.mean, 1e-9);
  EXPECT_NEAR(m.sd, 0, 1e-6);
}

/// n(D) ~ D^-(1 + a) on [low, high] has the mean a/(a-1) (low^(1-a) - high^(1-a)) / (low^-a - high^-a).
TEST(PackField, PowerLawHasItsMeanAndEnds) {
  auto spec = spec_of(40, 18, 0.5);
  spec.distribution = SizeDistribution::power_law;
  spec.exponent = 1.5;
  const Moments m = size_moments(pack_field(spec));
  const double a = spec.exponent;
  const double mean = a / (a - 1) * (std::pow(spec.min, 1 - a) - std::pow(spec.max, 1 - a)) /
                      (std::pow(spec.min, -a) - std::pow(spec.max, -a));
  EXPECT_NEAR(m.mean, mean, 0.05 * mean);
  EXPECT_GE(m.smallest, spec.min * (1 - 1e-12));
  EXPECT_LE(m.largest, spec.max * (1 + 1e-12));
}

TEST(PackField, RectanglesKeepTheirAspectAndParallelogramsTheirShear) {
  auto spec = spec_of(10, 8, 0.6, FloeShape::parallelogram);
  spec.aspect = 1.7;
  spec.shear = 25 * k_deg;
  for (const auto& floe : pack_field(spec).floes) {
    ASSERT_EQ(floe.outline.size(), 4u);
    const Vec2 a = floe.outline[1] - floe.outline[0], b = floe.outline[2] - floe.outline[1];
    EXPECT_NEAR(std::max(a.norm(), b.norm()) / std::min(a.norm(), b.norm()), 1.7, 1e-9);
    EXPECT_NEAR(std::abs(a.normalized().dot(b.normalized())), std::sin(spec.shear), 1e-9);
  }
}

/// Concentration counts the free water only, and no floe comes nearer to the outline than the margin.
TEST(PackField, KeepsClearOfAHullOutline) {
  auto spec = spec_of(20, 10, 0.85);
  spec.keep_out = {{{2, 5.4}, {6, 5.4}, {8, 6}, {6, 6.6}, {2, 6.6}}};
  spec.keep_out_margin = 0.1;
  const auto field = pack_field(spec);
  const double hull = geometry::polygon_moments(spec.keep_out[0]).area;
  double perimeter = 0;
  for (std::size_t i = 0; i < 5; ++i) perimeter += (spec.keep_out[0][(i + 1) % 5] - spec.keep_out[0][i]).norm();
  const double grown = hull + perimeter * 0.1 + k_pi * 0.01;
  const double free = 200 - grown;
  EXPECT_NEAR(test::ice_area(field) / free, field.concentration, 1e-4);  // corners are many-sided, not round
  EXPECT_NEAR(field.concentration, 0.85, 0.5 * spec.max * spec.max / free);
  EXPECT_GT(smallest_gap(field.floes), 0);
  test::expect_inside(spec, field);
  EXPECT_EQ(field.left_out, 0);
  for (const auto& floe : field.floes) {
    const auto& hull_outline = spec.keep_out[0];
    EXPECT_GE(std::max(separation(hull_outline, floe.outline), separation(floe.outline, hull_outline)), 0.0999);
  }
}

TEST(PackField, ImpossibleConcentrationSaysWhatIsReached) {
  auto spec = spec_of(5, 4, 0.99, FloeShape::disc);
  test::expect_refusal([&] { pack_field(spec); }, {"concentration: found 0.99", "discs block each other at about 0.8"});
}

TEST(PackField, AFloeLargerThanTheRegionIsNamed) {
  auto spec = spec_of(2, 1.5, 0.9, FloeShape::square);
  spec.distribution = SizeDistribution::fixed;
  spec.mean = 1.6;
  test::expect_refusal([&] { pack_field(spec); },
                       {"one floe, and it does not fit", "1.6 m across", "the region 1.5 m broad"});
}

template <class Change>
std::string refusal(const Change& change) {
  auto spec = spec_of(6, 6, 0.5);
  change(spec);
  return test::refusal([&] { pack_field(spec); });
}

TEST(PackField, WrongParametersAreNamed) {
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.high.x() = s.low.x(); }), "region: found 0");
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.concentration = 1.2; }), "concentration: found 1.2");
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.mean = -1; }), "size mean: found -1");
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.max = 0.1; }), "size max: found 0.1");
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.vertices_min = 2; }), "vertices: found 2");
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.aspect = 0.5; }), "aspect: found 0.5");
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.shear = 1.5; }), "shear_deg: found 85.9");
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.keep_out_margin = -1; }), "keep-out margin: found -1");
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.keep_out = {{{0, 0}, {0, 1}, {1, 1}}}; }), "keep-out outline 1");
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.high = s.low + Vec2(0.1, 0.1); }), "less than half a floe");
}

}  // namespace pack_field_test
}  // namespace nilas::field
