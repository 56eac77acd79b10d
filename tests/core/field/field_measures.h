#pragma once
/// Measures of ice fields, from their floes alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/field/field.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/polygon.h"

namespace nilas::test {

/// The largest overlap of two convex floes, or minus the smallest gap where none overlap [m].
inline double deepest_overlap(const field::FieldResult& field) {
  double deepest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < field.floes.size(); ++i)
    for (std::size_t j = i + 1; j < field.floes.size(); ++j)
      deepest = std::max(deepest, geometry::convex_overlap(field.floes[i].outline, field.floes[j].outline));
  return deepest;
}

/// The area of all floes [m^2].
inline double ice_area(const field::FieldResult& field) {
  double area = 0;
  for (const auto& floe : field.floes) area += geometry::polygon_moments(floe.outline).area;
  return area;
}

/// Expects that every floe lies inside the region.
inline void expect_inside(const field::PackedSpec& spec, const field::FieldResult& field) {
  for (const auto& floe : field.floes)
    for (const Vec2& corner : floe.outline)
      EXPECT_TRUE((corner.array() >= spec.low.array()).all() && (corner.array() <= spec.high.array()).all());
}

}  // namespace nilas::test
