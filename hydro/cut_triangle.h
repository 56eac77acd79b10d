#pragma once
/// A triangle that the water plane cuts.
#include <array>

#include "core/base/math.h"
#include "hydro/water_plane.h"

namespace nilas::hydro {

/// A triangle with one corner alone on its side of the water plane. The plane cuts the two edges that meet in this
/// corner. A point is wet where its height is below 0.
class CutTriangle {
 public:
  /// Takes the corners in the winding of the surface, and their heights. At least one corner is wet and one dry.
  CutTriangle(const std::array<Vec3, 3>& corners, const std::array<double, 3>& heights) {
    const bool a = heights[0] < 0, b = heights[1] < 0, c = heights[2] < 0;
    const std::size_t lone = b == c ? 0 : a == c ? 1 : 2, i = (lone + 1) % 3, j = (lone + 2) % 3;
    lone_wet_ = heights[lone] < 0;
    lone_ = corners[lone];
    next_ = corners[i];
    previous_ = corners[j];
    next_cut_ = cut(lone_, heights[lone], next_, heights[i]);
    previous_cut_ = cut(lone_, heights[lone], previous_, heights[j]);
  }
  /// The points where the outline leaves and enters the water, in the winding of the surface.
  const Vec3& leaves() const { return lone_wet_ ? next_cut_ : previous_cut_; }
  const Vec3& enters() const { return lone_wet_ ? previous_cut_ : next_cut_; }
  /// Calls visit(area, centroid, normal) for the wet polygon unless it has no area. `normal` is the triangle's unit
  /// normal.
  template <class Visit>
  void visit_wet(const Vec3& normal, const Visit& visit) const {
    constexpr double k_third = 1.0 / 3.0;  // centroid of a triangle
    const auto area_of = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
      return 0.5 * normal.dot((b - a).cross(c - a));
    };
    if (lone_wet_) {
      const double area = area_of(lone_, next_cut_, previous_cut_);
      if (area > 0) visit(area, Vec3(k_third * (lone_ + (next_cut_ + previous_cut_))), normal);
      return;
    }
    // The mean of the cuts along both diagonals has the same bits whichever way the triangle is wound.
    const Halves one = halves(area_of(next_cut_, next_, previous_), next_, area_of(next_cut_, previous_, previous_cut_),
                              previous_cut_, next_cut_ + previous_);
    const Halves other = halves(area_of(previous_cut_, next_, previous_), previous_,
                                area_of(previous_cut_, next_cut_, next_), next_cut_, previous_cut_ + next_);
    if (one.area > 0 && other.area > 0)
      visit(0.5 * (one.area + other.area), Vec3(0.5 * k_third * (one.triple + other.triple)), normal);
  }

 private:
  /// Two triangles that share a diagonal: their area, and three times their centroid.
  struct Halves {
    double area;
    Vec3 triple;
  };
  static Halves halves(double first, const Vec3& first_corner, double second, const Vec3& second_corner,
                       const Vec3& diagonal) {
    const double area = first + second;
    return {area, diagonal + first / area * first_corner + second / area * second_corner};
  }

  Vec3 cut(const Vec3& a, double a_height, const Vec3& b, double b_height) const {
    return lone_wet_ ? leaves_water(a, a_height, b, b_height) : leaves_water(b, b_height, a, a_height);
  }

  bool lone_wet_ = false;
  Vec3 lone_, next_, previous_;
  Vec3 next_cut_, previous_cut_;  ///< The cuts of the edges that meet in the lone corner.
};

}  // namespace nilas::hydro
