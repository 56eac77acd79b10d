#pragma once
/// The settings of a solve besides its problem, and its result.
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/choices/defaults.h"

namespace nilas::contact {

enum class SolveStatus { converged, iteration_limit, stalled, numerical_error };
const char* to_string(SolveStatus status);
/// The graver of two statuses, in the order of the enumeration.
inline SolveStatus worse(SolveStatus a, SolveStatus b) { return a < b ? b : a; }

struct ContactSolution {
  VecX r;  ///< 3 nc impulses on body B in the contact frame [N s]
  VecX v;  ///< nv velocities with r applied; empty for a local problem
  VecX u;  ///< 3 nc, H^T v + w, or W r + q of a local problem [m/s]
  SolveStatus status = SolveStatus::numerical_error;
  int iterations = 0;
  std::vector<double> history;  ///< law_map_m_s after each iteration, when asked for
  std::string message;          ///< message of a failure with its contact key; for auto also the rungs used; else empty
};

/// Settings that all solvers share; a solver's own settings are a struct in its header.
struct SolverSettings {
  /// Tolerance on law_map_m_s [m/s]. At 0, nsgs, pgs, eg and apgd do all max_iterations, and the other solvers continue
  /// until they stall.
  double tolerance = defaults::k_tolerance;
  int max_iterations = defaults::k_max_iterations;
  double max_seconds = 0;  ///< stop with iteration_limit after this wall time; 0: no limit [s]
  bool keep_history = false;
  int threads = 1;
};

}  // namespace nilas::contact
