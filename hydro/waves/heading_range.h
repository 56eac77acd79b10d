#pragma once
/// The headings of a database, and how values between them follow.
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"

namespace nilas::hydro {

/// Two headings of a list and a share between them.
struct HeadingPlace {
  std::size_t before = 0, after = 0;
  double share = 0;     ///< of the one after
  bool mirror = false;  ///< the value belongs to the mirror image: sway, roll and yaw change sign
  double turn = 0;      ///< angle by which the load of a round body is turned about Z [rad]

  /// Interpolates linearly between values of the list; for complex values in their real and imaginary parts.
  template <class Vector>
  Vector of(const std::vector<Vector>& values) const {
    Vector value = share == 0 ? values[before] : Vector((1 - share) * values[before] + share * values[after]);
    if (mirror)
      for (const int mode : {1, 3, 5}) value[mode] = -value[mode];  // sway, roll, yaw
    if (turn == 0) return value;
    const Mat3 about_z = Eigen::AngleAxisd(turn, Vec3::UnitZ()).toRotationMatrix();
    Vector turned;
    turned << about_z * value.template head<3>(), about_z * value.template tail<3>();
    return turned;
  }
};

/// What the form of a body says about headings that a database does not hold.
struct BodySymmetry {
  bool sides = false;  ///< it is its own mirror image in the plane y = 0
  bool round = false;  ///< it is a body of revolution about the Z axis
};

/// Rising headings [rad]. They may cover the whole circle. From 0 onwards they serve the other side of a body with
/// equal sides as well. One heading serves all directions of a round body. Otherwise only headings between the first
/// and the last have values. Values are not interpolated over a gap wider than k_widest_gap, nor over the one that
/// closes the circle: there only the headings themselves have values.
class HeadingRange {
 public:
  /// Linear interpolation of cos(heading) over 45 degrees is at most 1 - cos(22.5 deg) = 8 % too small; over 90 degrees
  /// it is 29 %. With room for the rounding of files [rad].
  static constexpr double k_widest_gap = 45.5 * k_deg;

  HeadingRange() = default;
  /// Throws InputError for an empty list or one that does not rise.
  HeadingRange(std::vector<double> headings, const BodySymmetry& body);
  /// Empty where the list has no value for this heading.
  std::optional<HeadingPlace> find(double heading) const;
  /// "-90 to 90 deg", for messages; with the gaps that are too wide.
  std::string text() const;

 private:
  double gap_after(std::size_t k) const;

  std::vector<double> headings_;
  bool circle_ = false, mirrored_ = false, round_ = false;
};

}  // namespace nilas::hydro
