#include "contact/problem/solution.h"

namespace nilas::contact {

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

}  // namespace nilas::contact
