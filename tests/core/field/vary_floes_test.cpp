#include "core/field/vary_floes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/bodies/bodies.h"
#include "core/field/sizes/distribution_statistics.h"

namespace nilas::field {
namespace vary_floes_test {

constexpr double k_infinite = std::numeric_limits<double>::infinity();
constexpr FloeProperty k_thickness = FloeProperty::thickness, k_density = FloeProperty::density,
                       k_flexural = FloeProperty::flexural_strength;
constexpr FloeValues k_means{0.04, 920, 4e4, 1e5, 3e3};

CutDistribution cut(SpreadKind kind, double cov) { return {kind, cov, 0.05, k_infinite}; }

MatX matrix(double ab, double ac = 0, double bc = 0) {
  MatX m(3, 3);
  m << 1, ab, ac, ab, 1, bc, ac, bc, 1;
  return m;
}

std::vector<PropertySpread> three(double correlation_length = 0) {
  return {{k_thickness, cut(SpreadKind::normal, 0.08), correlation_length},
          {k_density, cut(SpreadKind::uniform, 0.02), correlation_length},
          {k_flexural, cut(SpreadKind::weibull, 0.3), correlation_length}};
}

FieldFloe square_at(const Vec2& centre, double side) {
  FieldFloe floe;
  for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
    floe.outline.push_back(centre + 0.5 * side * corner);
  return floe;
}

/// Values of one property over many floes, side by side.
std::vector<std::vector<double>> samples(const FloeVariation& variation, int count) {
  std::vector<std::vector<double>> values(k_num_floe_properties);
  for (int i = 0; i < count; ++i) {
    FieldFloe floe = square_at({static_cast<double>(i), 0}, 1);
    variation.draw(floe, "floe " + std::to_string(i), k_means);
    for (const auto property : k_floe_properties)
      values[static_cast<std::size_t>(property)].push_back(value_of(floe, property));
  }
  return values;
}

/// Tolerances for 20000 floes: the distance that one sample in a hundred exceeds, and four standard errors for moments.
TEST(VaryFloes, EachPropertyFollowsItsDistribution) {
  constexpr int k_floes = 20000;
  const auto values = samples(FloeVariation(three(), matrix(0.5, 0.3), 5), k_floes);
  const double n = k_floes;
  for (const auto& spread : three()) {
    const auto p = static_cast<std::size_t>(spread.property);
    const auto asked = [&](double u) { return k_means[p] * spread.distribution.quantile(u); };
    EXPECT_LT(ks_distance(values[p], asked), 1.63 / std::sqrt(n)) << name_of(spread.property);
    const auto want = summary_of(asked), have = summary_of(values[p]);
    EXPECT_NEAR(have.mean, want.mean, 4 * want.sd / std::sqrt(n)) << name_of(spread.property);
    // the error of a deviation is at most sd/sqrt(2 n) for kurtosis up to 3, which these have
    EXPECT_NEAR(have.sd, want.sd, 4 * want.sd / std::sqrt(2 * n)) << name_of(spread.property);
  }
  EXPECT_EQ(summary_of(values[static_cast<std::size_t>(FloeProperty::compressive_strength)]).max, 0);
}

TEST(VaryFloes, TheScoresAreCorrelatedAsAsked) {
  constexpr int k_floes = 20000;
  const auto values = samples(FloeVariation(three(), matrix(-0.6, 0.5, 0), 5), k_floes);
  const auto expect = [&](std::size_t a, std::size_t b, double asked) {
    EXPECT_NEAR(score_correlation(values[a], values[b]), asked, 4 * (1 - asked * asked) / std::sqrt(1.0 * k_floes));
  };
  expect(0, 1, -0.6);
  expect(0, 2, 0.5);
  expect(1, 2, 0);
}

/// A draw depends on the floe's name and on properties that it is correlated with, not on others, their order or the
/// floes drawn before.
TEST(VaryFloes, ADrawStandsByItself) {
  const FloeVariation alone({three()[0]}, MatX::Identity(1, 1), 5), all(three(), matrix(0, 0.5), 5);
  std::vector<PropertySpread> turned{three()[2], three()[1], three()[0]};
  const FloeVariation reordered(turned, matrix(0, 0.5), 5);
  const auto full = samples(all, 50), single = samples(alone, 50), other = samples(reordered, 50);
  EXPECT_EQ(full[0], single[0]);
  EXPECT_EQ(full, other);
  EXPECT_EQ(full[1], samples(FloeVariation({three()[1]}, MatX::Identity(1, 1), 5), 50)[1]);
  FieldFloe floe = square_at({40, 0}, 1);
  all.draw(floe, "floe 40", k_means);
  EXPECT_EQ(floe.thickness, full[0][40]);
  EXPECT_NE(samples(FloeVariation(three(), matrix(0), 6), 1)[0], std::vector<double>{full[0][0]});
}

TEST(VaryFloes, WhatAFloeStatesStays) {
  FieldFloe floe = square_at({0, 0}, 1);
  floe.thickness = 0.123;
  FloeVariation(three(), matrix(0.5), 5).draw(floe, "a", k_means);
  EXPECT_EQ(floe.thickness, 0.123);
  EXPECT_GT(floe.flexural_strength, 0);
}

TEST(VaryFloes, WrongCorrelationsAreRefused) {
  EXPECT_THROW(FloeVariation(three(), matrix(0.9, 0.9, -0.9), 1), InputError);
  EXPECT_THROW(FloeVariation({three()[0], three()[0], three()[1]}, matrix(0), 1), InputError);
  auto mixed = three();
  mixed[1].correlation_length = 0.5;
  EXPECT_NO_THROW(FloeVariation(mixed, matrix(0, 0.5), 1));
  EXPECT_THROW(FloeVariation(mixed, matrix(0.1), 1), InputError);
}

class Texture : public testing::Test {
 protected:
  /// Thickness, density, strength, correlated, over 0.5 m.
  FloeVariation variation_{three(0.5), matrix(0.7, 0.4), 9};
};

/// The floe that carries the texture turns and drifts; the point of the ice keeps its value.
TEST_F(Texture, GoesWithTheFloe) {
  FieldFloe floe = square_at({3, 4}, 2);
  const FloeTexture texture = variation_.draw(floe, "a", k_means)[0].texture;
  bodies::Bodies bodies;
  bodies::BodySpec spec;
  spec.kind = bodies::BodyKind::floe;
  spec.shape =
      std::make_shared<const geometry::Shape>(geometry::prism_shape(square_at({0, 0}, 2).outline, floe.thickness));
  spec.mass = 1;
  spec.pose.p = {3, 4, 0};
  bodies.add(spec);
  const auto local = [&](const Vec3& p_G) {
    const Vec3 x = bodies.R_GB[0].transpose() * (p_G - bodies.p_GB[0]);
    return texture.at(x.x(), x.y());
  };
  const Vec3 mark(0.4, -0.7, 0);
  const double at_start = local(Vec3(3, 4, 0) + mark);
  const Quat turn(Eigen::AngleAxisd(1.2, Vec3::UnitZ()));
  bodies.set_pose(0, {-20, 7, 0.1}, turn);
  EXPECT_NEAR(local(bodies.p_GB[0] + turn * mark), at_start, 1e-12 * at_start);
  EXPECT_NE(local(Vec3(3, 4, 0) + mark), at_start);
}

/// Neighbouring floes were one sheet: where they touch, both have the same ice.
TEST_F(Texture, IsOneFieldOverAllFloes) {
  FieldFloe a = square_at({0, 0}, 1), b = square_at({1, 0}, 1);
  const auto left = variation_.draw(a, "a", k_means), right = variation_.draw(b, "b", k_means);
  ASSERT_EQ(left.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_DOUBLE_EQ(left[k].texture.at(0.5, 0.2), right[k].texture.at(-0.5, 0.2));
}

/// The reference is the midpoint rule on a fine grid, for a concave floe.
TEST_F(Texture, TheBodyHasTheMeanOverItsArea) {
  FieldFloe floe;
  floe.outline = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  const auto textures = variation_.draw(floe, "a", k_means);
  const Vec2 centre = geometry::polygon_moments(floe.outline).centroid;
  constexpr int k_per_metre = 50;
  for (const auto& textured : textures) {
    double sum = 0;
    int count = 0;
    for (int i = 0; i < 2 * k_per_metre; ++i)
      for (int j = 0; j < 3 * k_per_metre; ++j) {
        const Vec2 x((i + 0.5) / k_per_metre, (j + 0.5) / k_per_metre);
        if (x.x() > 1 && x.y() > 1) continue;
        sum += textured.texture.at(x.x() - centre.x(), x.y() - centre.y());
        ++count;
      }
    EXPECT_NEAR(value_of(floe, textured.property), sum / count, 2e-4 * sum / count) << name_of(textured.property);
  }
}

/// Distribution, and correlation between properties at one point, at 4000 distant places. (A lattice would sample the
/// waves at equal phases.)
TEST_F(Texture, PointsFollowTheDistributionsAndTheirCorrelation) {
  constexpr int k_points = 4000;
  FieldFloe floe = square_at({0, 0}, 0.1);
  const auto textures = variation_.draw(floe, "a", k_means);
  std::vector<std::vector<double>> values(textures.size());
  RandomStream places(1, "places");
  for (int i = 0; i < k_points; ++i) {
    const double x = places.uniform(-500, 500), y = places.uniform(-500, 500);
    for (std::size_t k = 0; k < textures.size(); ++k) values[k].push_back(textures[k].texture.at(x, y));
  }
  const double n = k_points;
  for (std::size_t k = 0; k < textures.size(); ++k) {
    const auto p = static_cast<std::size_t>(textures[k].property);
    EXPECT_LT(ks_distance(values[k], [&](double u) { return k_means[p] * three()[k].distribution.quantile(u); }),
              1.63 / std::sqrt(n));
  }
  EXPECT_NEAR(score_correlation(values[0], values[1]), 0.7, 4 * (1 - 0.49) / std::sqrt(n));
  EXPECT_NEAR(score_correlation(values[0], values[2]), 0.4, 4 * (1 - 0.16) / std::sqrt(n));
}

}  // namespace vary_floes_test
}  // namespace nilas::field
