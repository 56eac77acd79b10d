#pragma once
/// Generated contact problems with a name, each of them hard for some kind of solver.
#include <string>
#include <vector>

#include "contact/problem/problem.h"

namespace nilas::compare {

struct Challenge {
  std::string name, what;  ///< file name without extension; one line about the problem
  contact::ContactProblem problem;
};

/// The problems, which are the same each time, small ones first.
std::vector<Challenge> challenges();

}  // namespace nilas::compare
