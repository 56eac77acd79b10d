#include "core/field/spec/keep_out.h"

#include <cmath>

#include "core/base/error.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/polygon.h"

namespace nilas::field {

namespace {

constexpr double k_corner_step = 15 * k_deg;  ///< largest turn between two edges of a grown corner

Vec2 outward(const Vec2& from, const Vec2& to) { return Vec2(to.y() - from.y(), from.x() - to.x()).normalized(); }

/// Area of the overlap of `common` with the union of outlines first, first + 1, ...: inclusion and exclusion.
double covered_area(const std::vector<Vec2>& common, const std::vector<std::vector<Vec2>>& outlines,
                    std::size_t first) {
  double area = 0;
  for (std::size_t k = first; k < outlines.size(); ++k) {
    std::vector<Vec2> part = common;
    const auto& outline = outlines[k];
    for (std::size_t i = 0; i < outline.size() && !part.empty(); ++i) {
      const Vec2 normal = outward(outline[i], outline[(i + 1) % outline.size()]);
      part = cut_outline(part, normal, normal.dot(outline[i]));
    }
    if (part.empty()) continue;
    area += geometry::polygon_moments(part).area - covered_area(part, outlines, k + 1);
  }
  return area;
}

}  // namespace

std::vector<Vec2> cut_outline(const std::vector<Vec2>& outline, const Vec2& normal, double offset) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    const double ha = normal.dot(a) - offset, hb = normal.dot(b) - offset;
    if (ha <= 0) kept.push_back(a);
    if ((ha < 0 && hb > 0) || (ha > 0 && hb < 0)) kept.push_back(a + (b - a) * (ha / (ha - hb)));
  }
  return kept.size() < 3 ? std::vector<Vec2>{} : kept;
}

std::vector<Vec2> grown_outline(const std::vector<Vec2>& outline, double margin) {
  if (margin == 0) return outline;
  std::vector<Vec2> grown;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 before = outward(outline[(i + n - 1) % n], outline[i]),
               after = outward(outline[i], outline[(i + 1) % n]);
    const double turn = std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after));
    const int steps = std::max(1, static_cast<int>(std::ceil(turn / k_corner_step)));
    // Corners of the tangent polygon lie half a step from its touching points, outside the circle.
    const double reach = margin / std::cos(0.5 * turn / steps);
    const double start = std::atan2(before.y(), before.x());
    for (int k = 0; k < steps; ++k) {
      const double angle = start + turn * (k + 0.5) / steps;
      grown.push_back(outline[i] + reach * Vec2(std::cos(angle), std::sin(angle)));
    }
  }
  return grown;
}

std::vector<std::vector<Vec2>> grown_outlines(const std::vector<std::vector<Vec2>>& outlines, double margin) {
  if (!(margin >= 0) || !std::isfinite(margin))
    throw InputError("keep-out margin: found " + std::to_string(margin) + " m, allowed 0 or more");
  std::vector<std::vector<Vec2>> grown;
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    const auto& outline = outlines[k];
    if (outline.size() < 3 || !geometry::is_convex(outline) || !(geometry::polygon_moments(outline).area > 0))
      throw InputError("keep-out outline " + std::to_string(k + 1) + " is not convex and counter-clockwise");
    grown.push_back(grown_outline(outline, margin));
  }
  return grown;
}

double free_area(const Vec2& low, const Vec2& high, const std::vector<std::vector<Vec2>>& outlines) {
  const std::vector<Vec2> region{low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  return (high - low).prod() - covered_area(region, outlines, 0);
}

}  // namespace nilas::field
