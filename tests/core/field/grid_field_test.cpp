#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/field/field.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/polygon.h"
#include "tests/core/field/field_measures.h"
#include "tests/support/mentions.h"
#include "tests/support/refusal.h"

namespace nilas::field {
namespace grid_field_test {

GridSpec channel(int rows, int columns) {
  GridSpec spec;
  spec.low = {1, -1.3};
  spec.high = {7.7, 1.3};
  spec.rows = rows;
  spec.columns = columns;
  spec.gap = 0.013;
  return spec;
}

bool holds_mirror_image(const FieldResult& field, const std::vector<Vec2>& outline) {
  const auto is_image = [&](const FieldFloe& floe) {
    return std::all_of(outline.begin(), outline.end(), [&](const Vec2& corner) {
      return std::find(floe.outline.begin(), floe.outline.end(), Vec2(corner.x(), -corner.y())) != floe.outline.end();
    });
  };
  return std::any_of(field.floes.begin(), field.floes.end(), is_image);
}

void expect_apart(const FieldResult& field, double gap) { EXPECT_LE(test::deepest_overlap(field), -gap + 1e-12); }

/// n pieces and their gaps fill the region: concentration from the piece size alone.
TEST(GridField, RectanglesFillTheRegion) {
  const auto spec = channel(6, 10);
  const auto field = grid_field(spec);
  ASSERT_EQ(field.floes.size(), 60u);
  const double width = (6.7 - 9 * 0.013) / 10, height = (2.6 - 5 * 0.013) / 6;
  for (const auto& floe : field.floes) EXPECT_NEAR(geometry::polygon_moments(floe.outline).area, width * height, 1e-12);
  EXPECT_NEAR(field.concentration, 60 * width * height / (6.7 * 2.6), 1e-12);
  expect_apart(field, spec.gap);
}

TEST(GridField, MirrorSymmetricBitForBit) {
  for (const int rows : {4, 5})
    for (const double shear : {0.0, 0.3, -0.5})
      for (const bool stagger : {false, true}) {
        auto spec = channel(rows, 7);
        spec.shear = shear;
        spec.stagger = stagger;
        const auto field = grid_field(spec);
        for (const auto& floe : field.floes) EXPECT_TRUE(holds_mirror_image(field, floe.outline));
      }
}

TEST(GridField, PiecesOfEvenRowsComeInMirrorPairs) {
  const auto field = grid_field(channel(4, 5));
  for (std::size_t i = 0; i < field.floes.size(); i += 2) {
    const Vec2 upper = geometry::polygon_moments(field.floes[i].outline).centroid;
    const Vec2 lower = geometry::polygon_moments(field.floes[i + 1].outline).centroid;
    EXPECT_NEAR(upper.x(), lower.x(), 1e-12);
    EXPECT_NEAR(upper.y(), -lower.y(), 1e-12);
    EXPECT_GT(upper.y(), 0);
  }
}

/// Shear leaves the gap between slanted edges at the requested width, and the pieces inside the region.
TEST(GridField, ShearedPiecesKeepTheirGapsInsideTheRegion) {
  auto spec = channel(6, 8);
  spec.shear = 30 * k_deg;
  const auto field = grid_field(spec);
  expect_apart(field, spec.gap);
  for (const auto& floe : field.floes) {
    // a mirrored piece starts at its upper left corner, so its slanted edge leans the same way seen from there
    const Vec2 side = floe.outline[0] - floe.outline[3];
    EXPECT_NEAR(std::abs(side.x() / side.y()), std::tan(30 * k_deg), 1e-12);
    EXPECT_LT(side.x() * floe.outline[0].y(), 0);
    for (const Vec2& corner : floe.outline) {
      EXPECT_GE(corner.x(), spec.low.x() - 1e-12);
      EXPECT_LE(corner.x(), spec.high.x() + 1e-12);
    }
  }
}

TEST(GridField, StaggeredRowsHaveHalfPiecesAtTheirEnds) {
  auto spec = channel(4, 6);
  spec.stagger = true;
  const auto field = grid_field(spec);
  EXPECT_EQ(field.floes.size(), 2u * 6 + 2u * 7);
  expect_apart(field, spec.gap);
  const double width = (6.7 - 5 * 0.013) / 6;
  int halves = 0;
  for (const auto& floe : field.floes) {
    const double length = floe.outline[1].x() - floe.outline[0].x();
    halves += std::abs(length - 0.5 * (width - 0.013)) < 1e-12;
  }
  EXPECT_EQ(halves, 4);
}

TEST(GridField, PiecesThatMeetTheHullAreLeftOutAndCounted) {
  auto spec = channel(6, 10);
  spec.keep_out = {{{1, -0.2}, {3, -0.2}, {4, 0}, {3, 0.2}, {1, 0.2}}};
  spec.keep_out_margin = 0.02;
  const auto field = grid_field(spec);
  EXPECT_GT(field.left_out, 0);
  EXPECT_EQ(field.floes.size() + static_cast<std::size_t>(field.left_out), 60u);
  for (const auto& floe : field.floes) {
    EXPECT_LE(geometry::convex_overlap(floe.outline, spec.keep_out[0]), -0.0199);
    EXPECT_TRUE(holds_mirror_image(field, floe.outline));
  }
}

TEST(GridField, WrongParametersAreNamed) {
  const auto refusal = [](auto change) -> std::string {
    auto spec = channel(4, 4);
    change(spec);
    return test::refusal([&] { grid_field(spec); });
  };
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.rows = 0; }), "rows: found 0");
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.columns = -3; }), "columns: found -3");
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.gap = 1; }), "gap: found 1");
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.gap = -1; }), "gap: found -1");
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.columns = 10000; }), "columns: found 10000");
  EXPECT_PRED2(test::mentions, refusal([](auto& s) { s.high = s.low; }), "region: found 0");
}

}  // namespace grid_field_test
}  // namespace nilas::field
