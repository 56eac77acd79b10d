#pragma once
/// The wet part of a plane polygon given corner by corner, without storing it.
#include "core/base/math.h"
#include "hydro/water_plane.h"

namespace nilas {

/// Area and centroid of the part of a counter-clockwise polygon at heights < 0 (Sutherland and Hodgman 1974 against one
/// plane). Concave polygons are exact too: the bridges along the water line between separate wet parts enclose nothing.
class WetPolygon {
 public:
  /// `last`: the corner before the first one.
  WetPolygon(const Vec2& last, double last_height) : corner_(last), height_(last_height) {}
  /// The next corner in the polygon's own plane, and its height above water [m].
  void add(const Vec2& corner, double height) {
    const bool was_wet = height_ < 0, is_wet = height < 0;
    if (was_wet && !is_wet) append(leaves_water(corner_, height_, corner, height));
    if (!was_wet && is_wet) append(leaves_water(corner, height, corner_, height_));
    if (is_wet) append(corner);
    corner_ = corner;
    height_ = height;
  }
  double area() const { return area_; }
  /// `area()` must not be 0.
  Vec2 centroid() const { return first_ + moment_ / area_; }

 private:
  void append(const Vec2& point) {
    constexpr double k_triangle_centroid = 1.0 / 3.0;  // of the sum of the two edges from a corner
    if (empty_) first_ = last_ = point;
    empty_ = false;
    const Vec2 a = last_ - first_, b = point - first_;
    const double area = 0.5 * (a.x() * b.y() - a.y() * b.x());
    area_ += area;
    moment_ += k_triangle_centroid * area * (a + b);
    last_ = point;
  }

  Vec2 corner_;
  double height_;
  bool empty_ = true;
  Vec2 first_ = Vec2::Zero(), last_ = Vec2::Zero();
  double area_ = 0;
  Vec2 moment_ = Vec2::Zero();
};

}  // namespace nilas
