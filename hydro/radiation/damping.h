#pragma once
/// The radiation damping B(w) of a database over all frequencies, made ready for transforms.
#include <optional>
#include <string>
#include <vector>

#include "hydro/database/database.h"
#include "hydro/radiation/piecewise_cubic.h"

namespace nilas::hydro {

/// What was found in the damping of a file and what was done about it. Shares refer to damping that is scaled to a
/// peak of 1 in each mode.
struct DampingReport {
  double asymmetry = 0;  ///< largest |B_ij - B_ji|, of the scaled damping
  double lowest = 0;     ///< smallest eigenvalue of the scaled damping in the file; negative: the file gives energy
  double lowest_frequency = 0;     ///< where it is [rad/s]
  int negative = 0;                ///< number of used frequencies with a negative eigenvalue, which was set to zero
  double removed = 0;              ///< root-mean-square share of the damping that this removed
  double last_frequency = 0;       ///< last frequency that is used [rad/s]
  int dropped = 0;                 ///< number of frequencies above it that are not used
  double last_share = 0;           ///< damping at the last used frequency, as a share of its peak
  double tail_power = 0;           ///< n of the tail w^-n beyond it
  std::vector<std::string> notes;  ///< whole sentences about everything that was repaired or is doubtful
};

/// B(w) = S Bhat(w) S for all w >= 0, with the diagonal matrix S of `scale`.
/// - Bhat is symmetric, and positive semidefinite at the file's frequencies.
/// - At w = 0 it is zero. Between the frequencies it is a cubic spline.
/// - Beyond the last one it is Bhat(w_N) (w_N / w)^n up to 10 w_N, and zero from there. The power n is that of the fall
///   over the last fifth of the range, at least 3 and at most 8.
struct RadiationDamping {
  Vec6 scale = Vec6::Zero();             ///< root of the largest |B_ii|; 0: the mode radiates nothing
  std::vector<std::vector<int>> groups;  ///< modes that couple with each other, each group in rising order
  PiecewiseCubic scaled;                 ///< Bhat; a row holds the 36 entries
  double peak_frequency = 0;             ///< where the trace of Bhat is largest [rad/s]
  double high_frequency = 0;             ///< above it the trace is below 1e-3 of its peak [rad/s]
  double longest_memory = 0;             ///< half of the time after which the spacing of frequencies repeats [s]
  DampingReport report;
};

/// Prepares the damping of a database.
/// - Entries B_ij and B_ji are replaced by their mean. A difference above 10 % of the peaks is refused.
/// - Once all modes have fallen below 10 % of their peaks, the file's values are not used from the first frequency on
///   at which an eigenvalue is below -1 %. Panels do not resolve such short waves, or an irregular frequency lies
///   there.
/// - Other negative eigenvalues are set to zero. More than 5 % (root mean square) removed in this way is refused.
/// - Coupling below 1e-3 of the peaks is that of a mesh that is not quite symmetric. It is left out.
/// `highest`: frequencies above it are not used [rad/s]. Throws InputError naming the database's source.
RadiationDamping prepare_damping(const Database& database, std::optional<double> highest = std::nullopt);

}  // namespace nilas::hydro
