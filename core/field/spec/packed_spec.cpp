#include "core/field/spec/packed_spec.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.h"
#include "core/field/spec/keep_out.h"

namespace nilas::field {

namespace {

constexpr int k_most_vertices = 64;  ///< largest number of vertices of a polygon floe

void demand(bool holds, const char* parameter, double found, const char* allowed) {
  if (!holds) throw InputError(fmt::format("ice field: {}: found {}, allowed {}", parameter, found, allowed));
}

void check_sizes(const PackedSpec& spec) {
  demand(spec.mean > 0 && std::isfinite(spec.mean), "size mean", spec.mean, "more than 0 m");
  if (spec.distribution == SizeDistribution::fixed || spec.distribution == SizeDistribution::as_library) return;
  demand(spec.min > 0, "size min", spec.min, "more than 0 m");
  demand(spec.max >= spec.min && std::isfinite(spec.max), "size max", spec.max, "at least size min");
  demand(spec.sd >= 0 && std::isfinite(spec.sd), "size sd", spec.sd, "0 m or more");
  demand(std::isfinite(spec.exponent), "size exponent", spec.exponent, "a finite number");
}

void check_library(const PackedSpec& spec) {
  if (spec.shape == FloeShape::library && spec.library.empty())
    throw InputError("ice field: the library of outlines is empty");
  if (spec.distribution == SizeDistribution::as_library && spec.shape != FloeShape::library)
    throw InputError("ice field: size distribution: found as-library without a library of outlines");
}

void check_shape(const PackedSpec& spec) {
  demand(spec.vertices_min >= 3, "vertices", spec.vertices_min, "3 or more");
  demand(spec.vertices_max >= spec.vertices_min && spec.vertices_max <= k_most_vertices, "vertices", spec.vertices_max,
         "a largest number from the smallest to 64");
  demand(spec.aspect >= 1 && std::isfinite(spec.aspect), "aspect", spec.aspect, "1 or more");
  demand(std::abs(spec.shear) <= k_largest_shear, "shear_deg", spec.shear / k_deg, "-80 to 80");
}

}  // namespace

void check_packed_spec(const PackedSpec& spec) {
  const Vec2 side = spec.high - spec.low;
  demand(side.x() > 0 && std::isfinite(side.x()), "region", side.x(), "a length along X of more than 0 m");
  demand(side.y() > 0 && std::isfinite(side.y()), "region", side.y(), "a width along Y of more than 0 m");
  demand(spec.concentration > 0 && spec.concentration <= 1, "concentration", spec.concentration,
         "more than 0 and at most 1");
  demand(spec.overlap_tolerance >= 0 && spec.overlap_tolerance < 1, "overlap_tolerance", spec.overlap_tolerance,
         "0 to less than 1");
  check_sizes(spec);
  check_shape(spec);
  check_library(spec);
}

FieldBounds field_bounds(const PackedSpec& spec) {
  FieldBounds bounds{spec.low, spec.high, {}};
  for (auto& outline : grown_outlines(spec.keep_out, spec.keep_out_margin))
    bounds.obstacles.push_back(obstacle(std::move(outline)));
  return bounds;
}

double free_area(const FieldBounds& bounds) {
  std::vector<std::vector<Vec2>> outlines;
  for (const Obstacle& o : bounds.obstacles) outlines.push_back(o.outline.corners);
  return free_area(bounds.low, bounds.high, outlines);
}

}  // namespace nilas::field
