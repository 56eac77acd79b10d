#pragma once
/// What one run of a study of stored problems left: a row of compare.csv.
#include <limits>
#include <string>

#include "contact/measure/measure.h"

namespace nilas {

/// How a run ended, judged by law_map_m_s alone, whatever the solver claims.
enum class RunOutcome {
  solved,           ///< law_map_m_s at most the tolerance, within the time limit
  above_tolerance,  ///< claimed to have converged and had not
  iteration_limit,
  stalled,
  numerical_error,
  time_limit,
  crashed,         ///< ended by a signal or without a result
  not_applicable,  ///< the solver does not take the law, the size, or rolling friction; not run
  unreadable       ///< the file holds no problem that can be read; a single row, without a solver
};
const char* to_string(RunOutcome outcome);
/// In words for readers: "stalled", "ended by the time limit".
const char* in_words(RunOutcome outcome);

/// A tolerance: 1e-6.
std::string in_words(double tolerance);

constexpr double k_unknown = std::numeric_limits<double>::quiet_NaN();

/// A stored problem as far as a study needs it.
struct StudyProblem {
  std::string name;  ///< of the file, without its extension where that is unique
  std::string form;  ///< local, global
  int contacts = 0, velocities = 0;
  double mass_ratio = k_unknown;  ///< largest over smallest mass that a contact's side shows; NaN for the local form
};

struct StudyRow {
  StudyProblem problem;
  std::string solver, law;
  double tolerance = k_unknown;  ///< [m/s]
  RunOutcome outcome = RunOutcome::unreadable;
  std::string claimed;  ///< status by the solver itself
  int iterations = 0;
  double seconds = k_unknown;  ///< of the solve
  Residuals residuals;         ///< NaN where the run left none
  int open = 0, sticking = 0, sliding = 0;
  double wall = k_unknown, cpu = k_unknown;  ///< of the whole process [s]
  int exit_code = 0;
  std::string message;

  StudyRow();
  bool solved() const { return outcome == RunOutcome::solved; }
};

}  // namespace nilas
