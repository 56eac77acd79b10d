#pragma once
/// Coefficients of the wind load on a ship, over the angle of the relative wind.
///
/// The angle g is 0 for wind from ahead, 90 degrees for wind abeam and 180 degrees for wind from astern. With the
/// dynamic pressure q = 0.5 rho V^2 of the relative wind V, the frontal area A_F, the lateral area A_L and the length
/// L:
///   X = q C_X A_F, forward;   Y = q C_Y A_L, to the side to which the wind blows;
///   N = q C_N A_L L, about the midship section, which turns the bow to that side;
///   K = k s_H Y, about the waterline, which heels the ship to that side; s_H: height of the centroid of A_L.
/// Wind on the other side gives the mirror image.
///
/// Blendermann (1994), J. Wind Eng. Ind. Aerodyn. 51, 339-351, as in Fossen (2021), section 10.1:
///   C_X = -C_l cos g / d,  C_Y = C_t sin g / d,  d = 1 - (D / 2) (1 - (C_l A_F / A_L) / C_t) sin^2 2g,
///   C_N = (s_L / L - 0.18 (g - pi/2)) C_Y.
/// C_t is the drag across, C_l that along, referred to A_F, with one value from ahead and one from astern, D the
/// cross-force parameter and k the heel factor, by kinds of ships. s_L is the distance of the centroid of A_L forward
/// of the midship section. The load is that of a uniform wind.
#include <memory>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/choices/wind_choices.h"

namespace nilas::hydro {

/// The row of Blendermann's table. `delta` is D above, `kappa` is k.
struct BlendermannRow {
  double across, ahead, astern, delta, kappa;
};
const BlendermannRow& blendermann_row(BlendermannShip ship);

struct WindCoefficients {
  double CX = 0, CY = 0, CN = 0;
  double heel = 1;  ///< k
};

/// Coefficients from a file, linear between its angles.
class WindCoefficientTable {
 public:
  /// Reads a CSV file with the columns angle_deg,cx,cy,cn. Angles grow from 0 to 180. Throws FileError where the file
  /// cannot be read, and InputError with file and line for a wrong table.
  explicit WindCoefficientTable(const std::string& csv_file);
  /// `angle` from 0 to pi [rad].
  WindCoefficients at(double angle) const;

 private:
  std::vector<double> angle_;  ///< [rad]
  std::vector<Vec3> values_;
};

struct WindArea {
  WindAreaModel model = WindAreaModel::blendermann;
  BlendermannShip ship = BlendermannShip::research;   ///< for `blendermann`
  std::shared_ptr<const WindCoefficientTable> table;  ///< for `coefficients`
  double frontal = 0;                                 ///< A_F [m^2]
  double lateral = 0;                                 ///< A_L [m^2]
  double length = 0;                                  ///< L [m]
  double centroid = 0;                                ///< s_L [m]
  double height = 0;                                  ///< s_H [m]
};

/// The coefficients at an angle from -pi to pi [rad], positive where the wind blows to port. C_Y and C_N are those of
/// the axes of V: positive to port, and bow to port.
WindCoefficients wind_coefficients(const WindArea& area, double angle);

}  // namespace nilas::hydro
