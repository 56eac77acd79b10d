#pragma once
/// Generated contact problems that are hard for one kind of solver or another, by name.
#include <string>
#include <vector>

#include "contact/problem/problem.h"

namespace nilas {

struct Challenge {
  std::string name, what;  ///< file name without extension; one line of what is hard about it
  ContactProblem problem;
};

/// The same problems each time, small ones first.
std::vector<Challenge> challenges();

}  // namespace nilas
