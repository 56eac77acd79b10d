#pragma once
/// Wave excitation from all directions, as integrals over the heading need it.
#include <optional>
#include <string>
#include <vector>

#include "hydro/database/database.h"

namespace nilas::hydro {

/// What counts as large for each mode in added mass or damping: the largest diagonal term of a translation, and that
/// times the square of the body's size, or the largest of a rotation if larger. So terms that symmetry makes zero do
/// not set a scale of their own.
Vec6 mode_scale(const Database& database, const std::vector<Mat6>& matrices);
/// The size of the body, from the water that moves with it [m].
double body_size(const Database& database);

/// Whether nothing in the database contradicts a hull that is its own mirror image in the plane y = 0 of D. Surge,
/// heave and pitch are uncoupled from sway, roll and yaw: in added mass within a thousandth of the modes' scales, in
/// damping within a hundredth. Waves along that plane make no sway, roll and yaw, and where the file has a heading on
/// both sides, its loads are mirror images, within a hundredth of the largest loads.
bool is_symmetric_port_starboard(const Database& database);
/// Whether added mass does not distinguish surge from sway and roll from pitch within a thousandth: as that of a body
/// of revolution about the Z axis of D.
bool is_round(const Database& database);

/// One heading of a whole circle of them.
struct CircleHeading {
  double heading = 0;      ///< [rad]
  double weight = 0;       ///< part of the circle that it stands for [rad]
  std::size_t source = 0;  ///< place in the database
  bool mirrored = false;   ///< sway, roll and yaw change their sign
  double turned = 0;       ///< angle by which the loads are turned about Z [rad]
};

/// The headings of a whole circle, by the trapezoidal rule, which is exact for as many harmonics as there are headings.
/// Headings from 0 to 180 degrees are mirrored where the hull is symmetric. A single heading is turned where the body
/// is round. Empty where headings leave a gap wider than 45 degrees.
std::vector<CircleHeading> heading_circle(const Database& database);

/// The excitation at a frequency for a heading of the circle.
ComplexVec6 excitation_of(const Database& database, std::size_t frequency, const CircleHeading& heading);

}  // namespace nilas::hydro
