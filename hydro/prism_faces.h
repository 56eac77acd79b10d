#pragma once
/// Templates of PrismWater that visit the wet faces of a floe one by one.
#include <algorithm>
#include <cmath>

#include "hydro/wet_polygon.h"
#include "hydro/wetted.h"

namespace nilas::hydro {

template <class Visit>
void PrismWater::for_each_wet_face(const WaterPlane& plane, const Visit& visit) const {
  switch (cut(plane)) {
    case Cut::dry:
      return;
    case Cut::submerged:
      return visit_whole(visit);
    case Cut::sides_only:
      return visit_between_caps(plane, visit);
    case Cut::caps:
      return visit_clipped(plane, visit);
  }
}

template <class Visit>
void PrismWater::visit_whole(const Visit& visit) const {
  for (const double side : {-1.0, 1.0})
    visit(moments_.area, Vec3(moments_.centroid.x(), moments_.centroid.y(), side * half_), Vec3(0, 0, side));
  for (const Side& s : sides_) visit_whole(s, visit);
}

template <class Visit>
void PrismWater::visit_whole(const Side& s, const Visit& visit) const {
  const Vec2 middle = 0.5 * (s.start + s.end);
  visit(2 * half_ * s.length, Vec3(middle.x(), middle.y(), 0), Vec3(s.normal.x(), s.normal.y(), 0));
}

template <class Visit>
void PrismWater::visit_between_caps(const WaterPlane& plane, const Visit& visit) const {
  constexpr double k_third = 1.0 / 3.0;          // centroid of a trapezium from its parallel sides
  const double low = plane.up.z() > 0 ? -1 : 1;  // the cap that is under water
  visit(moments_.area, Vec3(moments_.centroid.x(), moments_.centroid.y(), low * half_), Vec3(0, 0, low));
  const Vec2 slope = -plane.up.head<2>() / plane.up.z();
  const double middle = -plane.offset / plane.up.z();
  // The clamp removes rounding: the caps count as uncut where the plane passes a corner within it.
  const auto wet_length = [&](const Vec2& q) {
    return std::clamp(half_ - low * (middle + slope.dot(q)), 0.0, 2 * half_);
  };
  for (const Side& s : sides_) {
    const double a = wet_length(s.start), b = wet_length(s.end), sum = a + b;
    if (sum == 0) continue;
    const double share = k_third / sum;
    const Vec2 q = share * (sum + a) * s.start + share * (sum + b) * s.end;
    const double from_cap = share * (a * a + b * b + a * b);
    visit(0.5 * sum * s.length, Vec3(q.x(), q.y(), low * (half_ - from_cap)), Vec3(s.normal.x(), s.normal.y(), 0));
  }
}

template <class Visit>
void PrismWater::visit_clipped(const WaterPlane& plane, const Visit& visit) const {
  const Vec2 slope = plane.up.head<2>(), deepest = deepest_point(plane).head<2>();
  for (const double side : {-1.0, 1.0}) {
    const double cap = plane.offset + side * half_ * plane.up.z();
    const Vec2& last = sides_.back().start;
    WetPolygon wet(deepest, last, cap + slope.dot(last));
    for (const Side& s : sides_) wet.add(s.start, cap + slope.dot(s.start));
    wet.close();
    if (!(wet.area() > 0)) continue;
    const Vec2 q = wet.centroid();
    visit(wet.area(), Vec3(q.x(), q.y(), side * half_), Vec3(0, 0, side));
  }
  for (const Side& s : sides_) visit_clipped(s, plane, visit);
}

template <class Visit>
void PrismWater::visit_clipped(const Side& s, const WaterPlane& plane, const Visit& visit) const {
  const double a = plane.offset + plane.up.head<2>().dot(s.start), b = plane.offset + plane.up.head<2>().dot(s.end);
  const double rise = half_ * plane.up.z();
  if (std::min(a, b) - std::abs(rise) >= 0) return;
  if (std::max(a, b) + std::abs(rise) < 0) return visit_whole(s, visit);
  // Coordinates in the plane of the side: the distance along the edge from its middle, and z.
  const double end = 0.5 * s.length;
  const Vec2 deepest(a < b ? -end : b < a ? end : 0.0, rise > 0 ? -half_ : half_);
  WetPolygon wet(deepest, {-end, half_}, a + rise);
  wet.add({-end, -half_}, a - rise);
  wet.add({end, -half_}, b - rise);
  wet.add({end, half_}, b + rise);
  wet.add({-end, half_}, a + rise);
  wet.close();
  if (!(wet.area() > 0)) return;
  const Vec2 centroid = wet.centroid();
  const Vec2 q = 0.5 * (s.start + s.end) + centroid.x() / s.length * (s.end - s.start);
  visit(wet.area(), Vec3(q.x(), q.y(), centroid.y()), Vec3(s.normal.x(), s.normal.y(), 0));
}

}  // namespace nilas::hydro
