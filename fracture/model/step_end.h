#pragma once
/// The end of a step, when floes may break: an exchange between the modules that find failures and the one that cuts.
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "contact/solved_problem.h"
#include "core/bodies/bodies.h"
#include "fracture/failure.h"
#include "fracture/model/fracture_event.h"

namespace nilas {

struct StepEnd {
  Bodies& bodies;
  double t = 0;               ///< [s]
  double step = 0;            ///< its length [s]
  const SolvedProblem& last;  ///< the contacts of the last substep
  /// Books what a break changed, with the bodies as they are now. Returns the energy that left them [J].
  std::function<double()> book_break;
  std::map<std::int64_t, std::vector<Failure>> failures;  ///< by floe, the likeliest first
  std::vector<FractureEvent> broken;                      ///< floes that broke
  std::vector<NewPiece> pieces;                           ///< the pieces in their place
};

}  // namespace nilas
