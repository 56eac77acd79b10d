#include "contact/problem/solution.h"

namespace nilas {

const char* to_string(SolveStatus status) {
  switch (status) {
    case SolveStatus::converged:
      return "converged";
    case SolveStatus::iteration_limit:
      return "iteration_limit";
    case SolveStatus::stalled:
      return "stalled";
    case SolveStatus::numerical_error:
      return "numerical_error";
  }
  return "unknown";
}

SolverSettings SolverSettings::started() const {
  SolverSettings running = *this;
  if (!deadline && max_seconds > 0)
    running.deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(max_seconds));
  return running;
}

}  // namespace nilas
