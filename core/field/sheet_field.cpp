#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/field/field.h"
#include "core/field/shapes/outline_difference.h"
#include "core/field/spec/keep_out.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/polygon.h"

namespace nilas::field {

namespace {

std::vector<Vec2> rectangle(const Vec2& low, const Vec2& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

bool lies_inside(const std::vector<Vec2>& outline, const Vec2& low, const Vec2& high) {
  return std::all_of(outline.begin(), outline.end(), [&](const Vec2& p) {
    return (p.array() > low.array()).all() && (p.array() < high.array()).all();
  });
}

/// The outline together with its open track: the area that it swept on its way from outside the region.
std::vector<Vec2> with_track(std::vector<Vec2> outline, const Vec2& low, const Vec2& high, const Vec2& aft) {
  const double beyond = 2 * (high - low).norm();
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) outline.push_back(outline[i] + beyond * aft.normalized());
  return geometry::convex_hull(std::move(outline));
}

void check_region(const char* kind, const Vec2& low, const Vec2& high) {
  if (!((high - low).minCoeff() > 0) || !low.allFinite() || !high.allFinite())
    throw InputError(fmt::format("{} field: region: found {} m by {} m, allowed more than 0 m", kind,
                                 high.x() - low.x(), high.y() - low.y()));
}

}  // namespace

FieldResult level_field(const LevelSpec& spec) {
  check_region("level", spec.low, spec.high);
  std::vector<std::vector<Vec2>> open = grown_outlines(spec.keep_out, spec.keep_out_margin);
  const double free = free_area(spec.low, spec.high, open);
  for (auto& outline : open)
    if (lies_inside(outline, spec.low, spec.high)) outline = with_track(outline, spec.low, spec.high, spec.aft);
  FieldResult result;
  double ice = 0;
  for (auto& piece : outline_difference(rectangle(spec.low, spec.high), open)) {
    ice += geometry::polygon_moments(piece).area;
    result.floes.push_back({std::move(piece)});
  }
  if (result.floes.empty()) throw InputError("level field: the keep-out outlines cover the region");
  result.concentration = ice / free;
  return result;
}

FieldResult channel_field(const ChannelSpec& spec) {
  check_region("channel", spec.ice.low, spec.ice.high);
  const double breadth = spec.ice.high.y() - spec.ice.low.y();
  if (!(spec.width > 0) || !(spec.width < breadth))
    throw InputError(
        fmt::format("channel field: channel_width: found {}, allowed more than 0 and less than the region's "
                    "{} m along Y",
                    spec.width, breadth));
  PackedSpec broken = spec.ice;
  const double middle = 0.5 * (spec.ice.low.y() + spec.ice.high.y());
  broken.low.y() = middle - 0.5 * spec.width;
  broken.high.y() = middle + 0.5 * spec.width;
  FieldResult result = pack_field(broken);
  LevelSpec sheet{
      spec.ice.low, {spec.ice.high.x(), broken.low.y()}, spec.ice.keep_out, spec.ice.keep_out_margin, spec.aft};
  for (const bool port : {false, true}) {
    if (port) sheet.low.y() = broken.high.y(), sheet.high.y() = spec.ice.high.y();
    for (FieldFloe& floe : level_field(sheet).floes) {
      floe.fixed = true;
      result.floes.push_back(std::move(floe));
    }
  }
  return result;
}

}  // namespace nilas::field
