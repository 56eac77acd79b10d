#include "apps/report/figures/ice_cover.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

namespace nilas::report {

namespace {

namespace bg = boost::geometry;
using CoverPoint = bg::model::d2::point_xy<double>;
using CoverPolygon = bg::model::polygon<CoverPoint>;
using CoverBox = bg::model::box<CoverPoint>;

}  // namespace

double ice_cover(const std::vector<std::vector<Vec3>>& outlines, const WaterWindow& window) {
  const CoverBox box({-0.5 * window.length, -0.5 * window.width}, {0.5 * window.length, 0.5 * window.width});
  double area = 0;
  for (const auto& outline : outlines) {
    CoverPolygon floe;
    for (const Vec3& corner : outline) {
      const Vec2 from = corner.head<2>() - window.middle;
      floe.outer().emplace_back(from.dot(window.ahead), cross2(window.ahead, from));
    }
    CoverBox reach;
    bg::envelope(floe, reach);
    if (!bg::intersects(reach, box)) continue;
    bg::correct(floe);
    if (!bg::is_valid(floe)) {
      CoverPolygon hull;
      bg::convex_hull(floe, hull);
      floe = hull;
    }
    std::vector<CoverPolygon> parts;
    bg::intersection(floe, box, parts);
    for (const CoverPolygon& part : parts) area += bg::area(part);
  }
  return area / (window.length * window.width);
}

}  // namespace nilas::report
