#pragma once
/// The retardation functions K(t) of a body, the memory of the waves that it made, and the added mass that goes with
/// them.
#include <optional>
#include <vector>

#include "hydro/database/database.h"
#include "hydro/radiation/damping.h"

namespace nilas::hydro {

/// K(t) = (2 / pi) int_0^inf B(w) cos(w t) dw [Cummins 1962; Ogilvie 1964], integrated exactly for the damping as
/// RadiationDamping describes it, and the integrals K1(t) = int_0^t K and K2(t) = int_0^t K1 of its spline in time.
struct Retardation {
  PiecewiseCubic scaled;  ///< S^-1 K S^-1 in rows of 36 entries, over the whole horizon that was computed
  double step = 0;        ///< spacing of the knots [s]
  double memory = 0;      ///< motion that is older counts as steady [s]
  double left = 0;        ///< root of the share of int K^2 (scaled) that lies beyond the memory
  /// Root of the share of int K^2 (scaled) beyond damping.longest_memory: the spacing of the file's frequencies does
  /// not resolve it, and it is what the spline of the damping makes of it.
  double unresolved = 0;
  std::vector<Mat6> K;       ///< at k step, up to the first knot at or beyond the memory [N/m ...]
  std::vector<Mat6> K1, K2;  ///< likewise [N s/m ...], [N s^2/m ...]
};

/// `memory`: nothing for the shortest at which no more than 1e-3 is left [s].
Retardation retardation(const RadiationDamping& damping, std::optional<double> memory = std::nullopt);

/// The added mass at infinite frequency, and how well the file's A(w) agrees with its own damping.
struct InfiniteAddedMass {
  Mat6 value = Mat6::Zero();
  bool from_file = false;
  Mat6 scatter = Mat6::Zero();  ///< median of |A_inf of one frequency - value|, over the used frequencies
  /// Largest difference over the used frequencies between A(w) of the file and Ogilvie's, as a share of
  /// sqrt(max A_ii max A_jj), and its root mean square.
  double worst = 0, root_mean_square = 0;
  double worst_frequency = 0;  ///< [rad/s]
};

/// A_inf of the file. Where it has none, it is the median over the used frequencies of Ogilvie's
///   A_inf = A(w) + (1 / w) int_0^inf K(t) sin(w t) dt [Ogilvie 1964].
/// The row of a file for zero frequency is not used: in finite depth A(w) rises towards zero frequency as log w and
/// does not tend to it.
InfiniteAddedMass infinite_added_mass(const Database& database, const RadiationDamping& damping,
                                      const Retardation& kernel);

/// The database with the added mass at infinite frequency of Ogilvie's relation, and notes that say so with its
/// scatter. Throws InputError for a database that has that added mass, and as prepare_damping() does.
Database with_infinite_added_mass(Database database);

}  // namespace nilas::hydro
