#pragma once
/// Volume and centre of a solid from the plane faces of its surface.
#include "core/base/math.h"
#include "core/base/order_free_sum.h"

namespace nilas::hydro {

/// Sum of the pyramids from one apex over all faces. A face in a plane through the apex adds nothing and may be left
/// out. With the apex on the water plane, the waterplane of a floating solid needs no face.
class PyramidSum {
 public:
  explicit PyramidSum(const Vec3& apex) : apex_(apex) {}
  /// Adds the pyramid over a face with this area [m^2], centroid [m] and outward unit normal.
  void add(double area, const Vec3& centroid, const Vec3& normal) {
    constexpr double k_pyramid_volume = 1.0 / 3.0;  // of base times height
    const Vec3 arm = centroid - apex_;
    const double volume = k_pyramid_volume * area * normal.dot(arm);
    volume_.add(volume);
    moment_.add(volume * arm);
  }
  double volume() const { return volume_.value(); }
  /// Centroid of the solid; `volume()` must not be 0.
  Vec3 centre() const {
    constexpr double k_pyramid_centroid = 3.0 / 4.0;  // share of the distance from the apex to the base's centroid
    return apex_ + k_pyramid_centroid / volume_.value() * moment_.value();
  }

 private:
  Vec3 apex_;
  OrderFreeSum volume_;
  OrderFreeVectorSum moment_;
};

}  // namespace nilas::hydro
