/// Ice that hulls have crushed through the whole thickness of a floe, and the cut that removes it.
#include <algorithm>

#include "fracture/cut/cut_outline.h"
#include "fracture/cut/smallest_box.h"
#include "fracture/model/crushing.h"

namespace nilas::fracture {

namespace {

/// The width of the strip of crushed ice that stays along a hull's surface, in thicknesses, and in widths of a narrow
/// hull. Faces that turn or back off a little must stay in ice.
constexpr double k_strip = 0.25, k_strip_of_width = 0.125;
/// The largest share of the columns that rounding may leave outside an outline [-].
constexpr double k_outside_rounding = 1e-9;

using Polygons = std::vector<std::vector<Vec2>>;

Placement in_floe(const bodies::Bodies& bodies, std::size_t hull, std::size_t floe) {
  const Mat3 to_floe = bodies.R_GB[floe].transpose();
  return {to_floe * bodies.R_GB[hull], to_floe * (bodies.p_GB[hull] - bodies.p_GB[floe])};
}

struct Box {
  Vec2 low = Vec2::Constant(1e300), high = Vec2::Constant(-1e300);

  void extend(const std::vector<Vec2>& points) {
    for (const Vec2& x : points) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
  }
};

void add_hull(const CrushingSurface& hull, const Placement& hull_in_floe, const geometry::Shape& floe,
              CrushedIce& ice) {
  const double h = floe.thickness;
  Box around;
  around.extend(floe.outline);
  const Vec2 beyond = 0.5 * (around.high - around.low);  // so that the box cuts no column within the outline
  around.low -= beyond;
  around.high += beyond;
  const auto reaches = [&](const geometry::ConvexPolytope& part) {
    const Vec3 centre = hull_in_floe.point(part.centre);
    return (centre.head<2>() - around.low).minCoeff() > -part.radius &&
           (around.high - centre.head<2>()).minCoeff() > -part.radius && std::abs(centre.z()) < part.radius + 0.5 * h;
  };
  std::vector<Vec2> all_corners;
  std::vector<std::size_t> near;
  for (std::size_t k = 0; k < hull.parts.size(); ++k) {
    if (!reaches(hull.parts[k])) continue;
    const std::vector<char> all_inner(hull.outer[k].size(), 0);
    const Vec2 centre = hull_in_floe.point(hull.parts[k].centre).head<2>(),
               reach = Vec2::Constant(hull.parts[k].radius);
    auto section = columns_inside(hull.parts[k], all_inner, hull_in_floe, 0, 0, centre - reach, centre + reach);
    if (section.empty()) continue;
    all_corners.insert(all_corners.end(), section.begin(), section.end());
    near.push_back(k);
    ice.sections.push_back(std::move(section));
  }
  if (near.empty()) return;
  const double width = smallest_box(all_corners).width;
  const double strip = std::min(k_strip * h, k_strip_of_width * width);
  for (const std::size_t k : near) {
    auto columns = columns_inside(hull.parts[k], hull.outer[k], hull_in_floe, h, strip, around.low, around.high);
    if (!columns.empty()) ice.columns.push_back(std::move(columns));
  }
}

Polygons closed(const Polygons& polygons) {
  Polygons lines = polygons;
  for (auto& line : lines) line.push_back(line.front());
  return lines;
}

/// Whether more than one piece of the floe would stay. Then a bridge of crushed ice must be cut out, however small it
/// is.
bool parts_floe(const std::vector<Vec2>& outline, const Failure& way) {
  const CutResult cut = cut_outline(outline, way.cracks);
  return std::count_if(cut.pieces.begin(), cut.pieces.end(),
                       [&](const CutPiece& piece) { return !is_squeezed_out(way.crushed, piece.outline); }) > 1;
}

}  // namespace

CrushedIce Crushing::crushed_through(const bodies::Bodies& bodies, std::int64_t floe) const {
  const std::size_t b = bodies.index_of(floe);
  CrushedIce ice;
  for (const CrushingSurface& hull : hulls_)
    if (near_hulls_.count({hull.id, floe}) > 0)
      add_hull(hull, in_floe(bodies, static_cast<std::size_t>(hull.body), b), *bodies.shape[b], ice);
  return ice;
}

std::vector<FloeBreak> Crushing::floes_to_clear(const bodies::Bodies& bodies, WarningCounts& warnings) const {
  std::set<std::int64_t> floes;
  for (const Ids& ids : near_hulls_) floes.insert(ids.second);
  std::vector<FloeBreak> breaks;
  for (const std::int64_t floe : floes) {
    const std::size_t b = bodies.index_of(floe);
    const geometry::Shape& shape = *bodies.shape[b];
    Failure way;
    way.kind = FailureKind::crushing;
    way.crushed = crushed_through(bodies, floe);
    Polygons cut_out;
    bool may_part = false;
    for (const Polygons& group : connected(way.crushed.columns)) {
      const ColumnArea columns = column_area(group, shape.outline);
      if (columns.area <= k_outside_rounding * shape.thickness * shape.thickness) continue;
      if (columns.outside > k_outside_rounding * columns.area) {
        cut_out.insert(cut_out.end(), group.begin(), group.end());
        for (const auto& column : group) may_part = may_part || times_inside(column, shape.outline) > 1;
      } else if (columns.area * shape.thickness > *clear_volume_) {
        warnings.warn("crushed ice inside floes",
                      "'" + bodies.name[b] +
                          "' surrounds the hull that crushes it: the ice is cut out once it reaches the floe's edge");
      }
    }
    const ColumnArea columns = column_area(cut_out, shape.outline);
    way.ratio = columns.area * shape.thickness / *clear_volume_;
    if (cut_out.empty() || (way.ratio <= 1 && !may_part)) continue;
    way.crushed.columns = std::move(cut_out);
    way.point = columns.centroid;
    way.cracks = closed(way.crushed.columns);
    if (way.ratio <= 1 && !parts_floe(shape.outline, way)) continue;
    breaks.push_back({floe, {std::move(way)}});
  }
  return breaks;
}

}  // namespace nilas::fracture
