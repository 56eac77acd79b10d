#pragma once
/// What an input file of MoorDyn states about the water.
#include <optional>
#include <string>

namespace nilas::vessel {

/// Values that the file states as one number; nothing where it does not, such as a bed that lies in a file of its own.
struct MoordynWater {
  std::optional<double> depth;    ///< WtrDpth [m]
  std::optional<double> density;  ///< rho or WtrDnsty [kg/m^3]
  std::optional<double> gravity;  ///< g [m/s^2]
};

/// Reads the section OPTIONS of MoorDyn's input: lines of a value and a keyword, in any case. Throws FileError for a
/// file that cannot be read.
MoordynWater moordyn_water(const std::string& file);

}  // namespace nilas::vessel
