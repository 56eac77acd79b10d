#pragma once
/// Checks of a hydrodynamic database against itself: they show wrong scaling, signs, phases and modes.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hydro/database/database.h"

namespace nilas::hydro {

/// Names of the modes, as messages and tables have them.
constexpr std::array<const char*, 6> k_mode_name{"surge", "sway", "heave", "roll", "pitch", "yaw"};

/// The pair of modes whose term differs most from its transpose. Without forward speed both are equal.
struct Asymmetry {
  double share = 0;  ///< sum of the differences over the frequencies, divided by that of the larger values
  bool in_damping = false;
  int i = 0, j = 0;                  ///< the term, from 0
  double frequency = 0;              ///< where the difference is largest [rad/s]
  double value = 0, transposed = 0;  ///< of (i, j) and (j, i) there [SI]
};

/// Damping that gives energy to the body: a diagonal term below zero by more than 1e-4 of the scale of its mode.
struct NegativeDamping {
  int mode = 0;
  double frequency = 0;  ///< [rad/s]
  double value = 0;      ///< [SI]
  double share = 0;      ///< of the scale of its mode
};

/// One mode in the relation of Haskind and Newman: damping that follows from the excitation, divided by the damping of
/// the file. It counts frequencies at which the damping is above a twentieth of its peak, and at which every other
/// heading gives the same within a twentieth; in shorter waves the headings are too few.
struct HaskindRatio {
  int mode = 0;
  int frequencies = 0;  ///< number of frequencies counted
  double median = 1, least = 1, largest = 1;
  double lowest = 0, highest = 0;  ///< frequencies that were counted [rad/s]
};

/// Loads of the longest wave against what still water gives. Values are 1 in the limit of long waves.
struct LongWave {
  double frequency = 0;              ///< [rad/s]
  double steepness = 0;              ///< wave number times the size of the body; small if the wave is long
  std::optional<double> heave;       ///< X3 / C33
  double horizontal_sign = 0;        ///< > 0 where horizontal loads lead the elevation as in Database; 0: unknown
  std::optional<double> horizontal;  ///< load over g k (rho V + A), where the volume is known
};

/// Motions that follow from the matrices against those of the file, for one mode.
struct Closure {
  int mode = 0;
  double worst = 0;            ///< largest |difference| over frequencies and headings [m/m, rad/m]
  double worst_frequency = 0;  ///< [rad/s]
  double share = 0;            ///< largest share of the motion, of motions above a fifth of the mode's largest
};

struct NaturalMode {
  int mode = 0;       ///< the mode with the largest part of the kinetic energy
  double period = 0;  ///< [s]
};

struct SelfCheck {
  Asymmetry asymmetry;
  std::vector<NegativeDamping> negative;
  std::vector<int> reversed;  ///< modes whose sum of damping over the frequencies is negative
  std::vector<HaskindRatio> haskind;
  std::string no_haskind;  ///< why that relation could not be tested; empty if it was
  std::optional<LongWave> long_wave;
  std::vector<Closure> closure;
  std::string no_closure;  ///< why motions could not be compared; empty if they were
};

/// All checks. `mass`: the rigid-body mass about the origin of D; else that of the database, if it has one.
/// Haskind-Newman [Newman 1977, 6.173]: B = k / (8 pi rho g c_g) int X X* d(heading), real part, with the wave number k
/// and the group velocity c_g of the depth. In deep water this is w^3 / (4 pi rho g^3) int |X|^2.
/// Long waves [Newman 1977, 6.19]: X3 -> C33, X1 -> i g k (rho V + A11) cos(heading).
SelfCheck check_database(const Database& database, const std::optional<Mat6>& mass = {});

/// A sentence about a check that does not hold.
struct Finding {
  bool severe = false;  ///< the database cannot be meant so
  std::string text;
};
std::vector<Finding> findings(const Database& database, const SelfCheck& check);

/// Undamped natural periods of the freely floating body from C x = w^2 (M + A(w)) x, longest first. Empty without
/// hydrostatic stiffness. A(w) is interpolated linearly, and held beyond the frequencies of the file.
std::vector<NaturalMode> natural_modes(const Database& database, const Mat6& mass);

/// A(w) between the frequencies of the file; held constant beyond them. The row of the infinite period is not used: in
/// finite depth the added mass of heave rises without limit towards it.
Mat6 added_mass_at(const Database& database, double frequency);

}  // namespace nilas::hydro
