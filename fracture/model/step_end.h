#pragma once
/// The end of a step, when floes may break. Modules that find failures hand them to the one that cuts.
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "contact/solved_problem.h"
#include "core/bodies/bodies.h"
#include "fracture/failure.h"
#include "fracture/model/fracture_event.h"

namespace nilas::fracture {

struct StepEnd {
  bodies::Bodies& bodies;
  double t = 0;                        ///< [s]
  double step = 0;                     ///< Length of the step [s].
  const contact::SolvedProblem& last;  ///< The contacts of the last substep.
  /// Enters the change of a break into the energy account, with the present bodies. Returns the energy that left them
  /// [J].
  std::function<double()> book_break;
  std::map<std::int64_t, std::vector<Failure>> failures;  ///< Failure modes by floe, in the order of trial.
  std::vector<FractureEvent> broken;                      ///< Floes that broke.
  std::vector<NewPiece> pieces;                           ///< The pieces in their place.
};

}  // namespace nilas::fracture
