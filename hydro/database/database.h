#pragma once
/// Hydrodynamic coefficients of one floating body, as potential-flow programs (boundary element methods) give them.
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"

namespace nilas::hydro {

using ComplexVec6 = Eigen::Matrix<std::complex<double>, 6, 1>;

/// All values in SI units, whatever the form of the file. Modes are surge, sway, heave, roll, pitch, yaw.
/// Frame D of the database: X forward, Y to port, Z up. Its XY plane is the still water, and its origin is the point to
/// which the modes of rotation and all moments refer.
/// Time: a quantity is Re(x exp(+i w t)). The incident wave of unit amplitude that travels towards `heading`, an angle
/// from X towards Y, has the elevation Re(exp(i (w t - k (x cos heading + y sin heading)))) [Newman 1977; WAMIT].
struct Database {
  std::string source;                                         ///< the files it was read from
  double density = 0, gravity = 0;                            ///< of the computation [kg/m^3, m/s^2]
  std::optional<double> depth;                                ///< [m]; nothing: infinite
  std::optional<double> volume;                               ///< displaced volume [m^3]
  std::optional<Vec3> centre_of_buoyancy, centre_of_gravity;  ///< frame D [m]
  std::optional<Mat6> restoring;  ///< hydrostatic stiffness C, with the weight at the centre of gravity if known
  std::optional<Mat6> mass;       ///< rigid-body mass about the origin of D, where the file has it

  std::vector<double> frequency;            ///< rising, > 0 [rad/s]
  std::vector<Mat6> added_mass;             ///< A(w), one per frequency
  std::vector<Mat6> damping;                ///< B(w), one per frequency
  std::optional<Mat6> added_mass_zero;      ///< A(0)
  std::optional<Mat6> added_mass_infinite;  ///< A(infinity)

  std::vector<double> heading;                       ///< rising [rad]
  std::vector<std::vector<ComplexVec6>> excitation;  ///< X, [frequency][heading], per metre of amplitude
  std::vector<std::vector<ComplexVec6>> motion;      ///< response amplitude operators of the file; may be empty
  std::vector<std::vector<Vec6>> drift;              ///< mean drift load per square metre of amplitude; may be empty
  std::vector<std::string> notes;                    ///< whole sentences: what the reader left out or took for granted
};

}  // namespace nilas::hydro
