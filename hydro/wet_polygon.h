#pragma once
/// The wet part of a plane polygon given corner by corner, without storing it.
#include "core/base/math.h"
#include "core/base/order_free_sum.h"
#include "hydro/water_plane.h"

namespace nilas {

/// Area and centroid of the part of a counter-clockwise polygon at heights < 0 (Sutherland and Hodgman 1974 against one
/// plane): all corners, then close(), then the results. Concave polygons are exact too: the bridges along the water
/// line between separate wet parts enclose nothing.
class WetPolygon {
 public:
  /// `reference`: a point in or near the wet part, so that no digits are lost. `last`: the corner before the first
  /// one.
  WetPolygon(const Vec2& reference, const Vec2& last, double last_height)
      : reference_(reference), corner_(last), height_(last_height) {}
  /// The next corner in the polygon's own plane, and its height above water [m].
  void add(const Vec2& corner, double height) {
    const bool was_wet = height_ < 0, is_wet = height < 0;
    if (was_wet && !is_wet) append(leaves_water(corner_, height_, corner, height));
    if (!was_wet && is_wet) append(leaves_water(corner, height, corner_, height_));
    if (is_wet) append(corner);
    corner_ = corner;
    height_ = height;
  }
  /// Joins the last corner to the first; to be called once, after all corners.
  void close() {
    if (!empty_) add_triangle(last_, first_);
  }
  double area() const { return area_.value(); }
  /// `area()` must not be 0.
  Vec2 centroid() const { return reference_ + Vec2(moment_x_.value(), moment_y_.value()) / area_.value(); }

 private:
  void append(const Vec2& point) {
    const Vec2 arm = point - reference_;
    if (empty_)
      first_ = arm;
    else
      add_triangle(last_, arm);
    empty_ = false;
    last_ = arm;
  }

  void add_triangle(const Vec2& a, const Vec2& b) {
    constexpr double k_triangle_centroid = 1.0 / 3.0;  // of the sum of the two edges from a corner
    const double area = 0.5 * (a.x() * b.y() - a.y() * b.x());
    area_.add(area);
    moment_x_.add(k_triangle_centroid * area * (a.x() + b.x()));
    moment_y_.add(k_triangle_centroid * area * (a.y() + b.y()));
  }

  Vec2 reference_;
  Vec2 corner_;
  double height_;
  bool empty_ = true;
  Vec2 first_ = Vec2::Zero(), last_ = Vec2::Zero();  ///< from the reference
  OrderFreeSum area_, moment_x_, moment_y_;
};

}  // namespace nilas
