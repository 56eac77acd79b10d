#pragma once
/// Solves contact problems, by any solver of Nilas.
///
///   const nilas::Problem problem = nilas::Problem::read("jam.hdf5");
///   const nilas::Solution solution = nilas::solve(problem, {.solver = "auto", .tolerance = 1e-8});
///   std::cout << solution.status << ", " << solution.residuals.natural_map_m_s << " m/s\n";
#include <span>
#include <string>
#include <vector>

#include "nilas/error.h"
#include "nilas/export.h"
#include "nilas/problem.h"

namespace nilas {

struct SolveSettings {
  std::string solver = "auto";  ///< a name of solver_list()
  std::string law = "coulomb";  ///< coulomb, ccp, pyramid, pyramid-K with K facets, or frictionless
  double tolerance = 1e-8;      ///< on Residuals::law_map_m_s [m/s]
  int max_iterations = 100000;  ///< at least 1
  double max_seconds = 60;      ///< of wall time; 0: no limit [s]
  int threads = 1;              ///< at least 1; the results do not depend on it
  bool keep_history = false;    ///< whether Solution::history is filled
};

struct Solution {
  std::vector<double> impulses;            ///< 3 nc [N s]
  std::vector<double> contact_velocities;  ///< 3 nc [m/s]
  std::vector<double> velocities;          ///< those of the bodies; empty in the local form
  /// converged, iteration_limit, stalled or numerical_error: `converged` only where the measured residual says so
  std::string status;
  bool converged = false;
  int iterations = 0;
  double seconds = 0;           ///< wall time of the solve [s]
  std::string message;          ///< what a failure was, or which steps `auto` took
  std::vector<double> history;  ///< residual after each iteration [m/s]
  Residuals residuals;          ///< of the impulses, measured independently of the solver
};

/// Solves a problem. guess: 3 nc impulses to begin with, or empty. A problem that is not solved is no error: see
/// Solution::status. Throws Error for unknown names, for a law or a problem that the solver does not take, and where
/// sizes or numbers are wrong.
NILAS_API Solution solve(const Problem& problem, const SolveSettings& settings = {},
                         std::span<const double> guess = {});

/// Measures impulses, 3 nc [N s]. Throws Error.
NILAS_API Residuals measure(const Problem& problem, std::span<const double> impulses,
                            const std::string& law = "coulomb");

/// A solver and the laws that it takes.
struct SolverInfo {
  std::string name, summary;
  std::vector<std::string> laws;
};
NILAS_API std::vector<SolverInfo> solver_list();

/// The version of the library, as 0.2.0.
NILAS_API std::string version();

}  // namespace nilas
