#pragma once
/// The wet part of a plane polygon that is given corner by corner. No corners are stored.
#include "core/base/math.h"
#include "core/base/order_free_sum.h"
#include "hydro/water_plane.h"

namespace nilas::hydro {

/// Area and centroid of the part of a counter-clockwise polygon at heights < 0, clipped against one plane as Sutherland
/// and Hodgman (1974) do. Add all corners, call close(), then read the results. Concave polygons are exact too: the
/// bridges along the waterline between separate wet parts enclose no area.
class WetPolygon {
 public:
  /// `reference` is a point in or near the wet part, so that no digits are lost. `last` is the polygon's last corner,
  /// which precedes the first one, with its height above water [m].
  WetPolygon(const Vec2& reference, const Vec2& last, double last_height)
      : reference_(reference), corner_(last), height_(last_height) {}
  /// Adds the next corner, in the polygon's own plane, with its height above water [m].
  void add(const Vec2& corner, double height) {
    const bool was_wet = height_ < 0, is_wet = height < 0;
    if (was_wet && !is_wet) append(leaves_water(corner_, height_, corner, height));
    if (!was_wet && is_wet) append(leaves_water(corner, height, corner_, height_));
    if (is_wet) append(corner);
    corner_ = corner;
    height_ = height;
  }
  /// Joins the last corner to the first. Call it once, after all corners.
  void close() {
    if (!empty_) add_triangle(last_, first_);
  }
  double area() const { return area_.value(); }
  /// The centroid [m]; area() must not be 0.
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
  Vec2 first_ = Vec2::Zero(), last_ = Vec2::Zero();  ///< The first and the last wet corner, from the reference [m].
  OrderFreeSum area_, moment_x_, moment_y_;
};

}  // namespace nilas::hydro
