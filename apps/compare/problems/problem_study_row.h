#pragma once
/// The result of one run of a study of stored problems: a row of compare.csv.
#include <string>

#include "apps/compare/workshop/special_numbers.h"
#include "contact/measure/measure.h"

namespace nilas::compare {

/// How a run ended. Whether it is solved depends on law_map_m_s and the time alone, whatever the solver reports.
enum class RunOutcome {
  solved,           ///< law_map_m_s at most the tolerance, within the time limit
  above_tolerance,  ///< the solver reported convergence, but law_map_m_s is above the tolerance
  iteration_limit,
  stalled,
  numerical_error,
  time_limit,
  crashed,         ///< ended by a signal or without a result
  not_applicable,  ///< the solver does not take the law, the size, or rolling friction; not run
  unreadable       ///< the file holds no problem that can be read; a single row, without a solver
};
const char* to_string(RunOutcome outcome);
/// The outcome in words for readers: "stalled", "time limit".
const char* in_words(RunOutcome outcome);

/// A tolerance as text, such as "1e-6".
std::string in_words(double tolerance);

/// The figures of a stored problem that a study needs.
struct StudyProblem {
  std::string name;  ///< name of the file, without its extension if that is unique
  std::string form;  ///< "local" or "global"
  int contacts = 0, velocities = 0;
  double mass_ratio = k_unknown;  ///< see contact_mass_ratio(); NaN for the local form
};

struct StudyRow {
  StudyProblem problem;
  std::string solver, law;
  double tolerance = k_unknown;  ///< tolerance of the solver [m/s]
  RunOutcome outcome = RunOutcome::unreadable;
  std::string claimed;  ///< status that the solver reports
  int iterations = 0;
  double seconds = k_unknown;    ///< time of the solve [s]
  contact::Residuals residuals;  ///< NaN if the run left none
  int open = 0, sticking = 0, sliding = 0;
  double wall = k_unknown, cpu = k_unknown;  ///< times of the whole process [s]
  int exit_code = 0;
  std::string message;

  StudyRow();
  bool solved() const { return outcome == RunOutcome::solved; }
};

}  // namespace nilas::compare
