#include "core/field/spec/loose_floe.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/mass_properties.h"
#include "core/geometry/polygon.h"

namespace nilas::field {

LooseFloe loose_floe(std::vector<Vec2> outline) {
  const geometry::PolygonMoments moments = geometry::polygon_moments(outline);
  LooseFloe floe;
  floe.area = moments.area;
  floe.polar_moment = moments.xx + moments.yy;
  floe.centre = moments.centroid;
  floe.shape = std::move(outline);
  for (Vec2& corner : floe.shape) {
    corner -= floe.centre;
    floe.radius = std::max(floe.radius, corner.norm());
  }
  return floe;
}

LooseFloe hulled_floe(const std::vector<Vec2>& outline) {
  if (geometry::is_convex(outline)) return loose_floe(outline);
  LooseFloe floe = loose_floe(geometry::convex_hull(outline));
  floe.fill = geometry::polygon_moments(outline).area / floe.area;
  for (const Vec2& corner : outline) floe.notched.push_back(corner - floe.centre);
  return floe;
}

std::vector<Vec2> placed_ice(const LooseFloe& floe) {
  const double c = std::cos(floe.angle), s = std::sin(floe.angle);
  std::vector<Vec2> ice = floe.notched.empty() ? floe.shape : floe.notched;
  for (Vec2& corner : ice)
    corner = floe.centre + Vec2(c * corner.x() - s * corner.y(), s * corner.x() + c * corner.y());
  return ice;
}

LooseFloe with_area(LooseFloe floe, double area) {
  const double scale = std::sqrt(area / floe.area);
  for (Vec2& corner : floe.shape) corner *= scale;
  for (Vec2& corner : floe.notched) corner *= scale;
  floe.radius *= scale;
  floe.polar_moment *= scale * scale * scale * scale;
  floe.area = area;
  return floe;
}

void place_outline(const LooseFloe& floe, double scale, ConvexOutline& outline) {
  const double c = scale * std::cos(floe.angle), s = scale * std::sin(floe.angle);
  outline.corners.resize(floe.shape.size());
  for (std::size_t i = 0; i < floe.shape.size(); ++i) {
    const Vec2& corner = floe.shape[i];
    outline.corners[i] = floe.centre + Vec2(c * corner.x() - s * corner.y(), s * corner.x() + c * corner.y());
  }
  fill_normals(outline);
}

std::vector<ConvexOutline> placed_outlines(const std::vector<LooseFloe>& floes) {
  std::vector<ConvexOutline> outlines(floes.size());
  for (std::size_t i = 0; i < floes.size(); ++i) place_outline(floes[i], 1, outlines[i]);
  return outlines;
}

Obstacle obstacle(std::vector<Vec2> outline) {
  Obstacle result;
  result.outline.corners = std::move(outline);
  fill_normals(result.outline);
  result.low = result.high = result.outline.corners.front();
  for (const Vec2& corner : result.outline.corners) {
    result.low = result.low.cwiseMin(corner);
    result.high = result.high.cwiseMax(corner);
  }
  return result;
}

bool is_near(const Obstacle& obstacle, const Vec2& centre, double radius, double distance) {
  const Vec2 nearest = centre.cwiseMax(obstacle.low).cwiseMin(obstacle.high);
  return (centre - nearest).norm() < radius + distance;
}

}  // namespace nilas::field
