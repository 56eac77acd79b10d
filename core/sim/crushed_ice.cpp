/// Ice that hulls have crushed through its whole thickness, and the cut that takes it out of its floe.
#include <algorithm>
#include <set>

#include "core/bodies/mass_properties.h"
#include "core/sim/crushing.h"

namespace nilas {

namespace {

/// Of the strip of crushed ice that stays along a hull's surface, in thicknesses: wide enough that faces which turn or
/// back off a little stay in ice.
constexpr double k_strip = 0.25;
/// A share of the columns that rounding leaves outside an outline.
constexpr double k_rounding = 1e-9;

Placement in_floe(const Bodies& bodies, std::size_t hull, std::size_t floe) {
  const Mat3 to_floe = bodies.R_GB[floe].transpose();
  return {to_floe * bodies.R_GB[hull], to_floe * (bodies.p_GB[hull] - bodies.p_GB[floe])};
}

void add_hull(const CrushingSurface& hull, const Placement& hull_in_floe, const Shape& floe, CrushedIce& ice) {
  Vec2 low = floe.outline.front(), high = low;
  for (const Vec2& x : floe.outline) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const Vec2 beyond = 0.5 * (high - low);  // the box must cut no column within the outline
  low -= beyond;
  high += beyond;
  const auto add = [&](std::vector<Vec2> polygon, std::vector<std::vector<Vec2>>& polygons) {
    if (!polygon.empty()) polygons.push_back(std::move(polygon));
  };
  for (std::size_t k = 0; k < hull.parts.size(); ++k) {
    const double h = floe.thickness;
    add(columns_inside(hull.parts[k], hull.outer[k], hull_in_floe, h, k_strip * h, low, high), ice.columns);
    add(columns_inside(hull.parts[k], hull.outer[k], hull_in_floe, 0, 0, low, high), ice.sections);
  }
}

std::vector<std::vector<Vec2>> closed(const std::vector<std::vector<Vec2>>& polygons) {
  std::vector<std::vector<Vec2>> lines = polygons;
  for (auto& line : lines) line.push_back(line.front());
  return lines;
}

}  // namespace

CrushedIce Crushing::crushed_through(const Bodies& bodies, std::int64_t floe) const {
  const std::size_t b = bodies.index_of(floe);
  CrushedIce ice;
  for (const CrushingSurface& hull : hulls_)
    if (volume_.count({hull.id, floe}) > 0)
      add_hull(hull, in_floe(bodies, static_cast<std::size_t>(hull.body), b), *bodies.shape[b], ice);
  return ice;
}

std::vector<FloeBreak> Crushing::floes_to_clear(const Bodies& bodies, WarningCounts& warnings) const {
  if (!clear_volume_) return {};
  std::map<std::int64_t, double> in_hulls;  // no less than what is crushed through
  for (const auto& [ids, volume] : volume_)
    if (is_hull(static_cast<int>(bodies.index_of(ids.first)))) in_hulls[ids.second] += volume;
  std::vector<FloeBreak> breaks;
  for (const auto& [floe, volume] : in_hulls) {
    if (volume <= *clear_volume_) continue;
    const std::size_t b = bodies.index_of(floe);
    const Shape& shape = *bodies.shape[b];
    Failure way;
    way.crushed = crushed_through(bodies, floe);
    const ColumnArea columns = column_area(way.crushed, shape.outline);
    way.kind = FailureKind::crushing;
    way.ratio = columns.area * shape.thickness / *clear_volume_;
    if (way.ratio <= 1) continue;
    if (columns.outside <= k_rounding * columns.area &&
        columns.area < (1 - k_rounding) * polygon_moments(shape.outline).area) {
      warnings.warn("crushed ice inside floes",
                    "'" + bodies.name[b] +
                        "' surrounds the hull that crushes it: the ice is cut out once it reaches the floe's edge");
      continue;
    }
    way.point = columns.centroid;
    way.cracks = closed(way.crushed.columns);
    breaks.push_back({floe, {std::move(way)}});
  }
  return breaks;
}

}  // namespace nilas
