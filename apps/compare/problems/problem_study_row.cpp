#include "apps/compare/problems/problem_study_row.h"

#include <fmt/format.h>

#include "apps/compare/workshop/special_numbers.h"

namespace nilas::compare {

const char* to_string(RunOutcome outcome) {
  switch (outcome) {
    case RunOutcome::solved:
      return "solved";
    case RunOutcome::above_tolerance:
      return "above_tolerance";
    case RunOutcome::iteration_limit:
      return "iteration_limit";
    case RunOutcome::stalled:
      return "stalled";
    case RunOutcome::numerical_error:
      return "numerical_error";
    case RunOutcome::time_limit:
      return "time_limit";
    case RunOutcome::crashed:
      return "crashed";
    case RunOutcome::not_applicable:
      return "not_applicable";
    case RunOutcome::unreadable:
      break;
  }
  return "unreadable";
}

const char* in_words(RunOutcome outcome) {
  switch (outcome) {
    case RunOutcome::solved:
      return "solved";
    case RunOutcome::above_tolerance:
      return "claimed, not reached";
    case RunOutcome::iteration_limit:
      return "iteration limit";
    case RunOutcome::stalled:
      return "stalled";
    case RunOutcome::numerical_error:
      return "numerical error";
    case RunOutcome::time_limit:
      return "time limit";
    case RunOutcome::crashed:
      return "crashed";
    case RunOutcome::not_applicable:
      return "not applicable";
    case RunOutcome::unreadable:
      break;
  }
  return "unreadable";
}

std::string in_words(double tolerance) {
  std::string text = fmt::format("{:g}", tolerance);
  for (const char* padded : {"e-0", "e+0"})
    if (const std::size_t at = text.find(padded); at != std::string::npos) text.erase(at + 2, 1);
  return text;
}

StudyRow::StudyRow() {
  for (const auto& column : contact::residual_columns()) residuals.*column.member = k_unknown;
}

}  // namespace nilas::compare
