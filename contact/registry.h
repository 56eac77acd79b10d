#pragma once
/// Registry of the solvers by name, for `nilas solvers` and for scenes.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/solvers/solver.h"
#include "core/choices/solver_name.h"

namespace nilas::contact {

struct SolverEntry {
  std::string name;
  std::string summary;  ///< one sentence: method, cost per iteration, when to use it
  std::vector<Law> laws;
  std::function<std::unique_ptr<solvers::ContactSolver>(const SolverSettings&)> make;
  bool moments = false;     ///< see SolverFacts
  bool order_free = false;  ///< see SolverFacts
  std::optional<SolverName> in_scenes =
      {};  ///< the name by which a scene asks for it; empty for solvers for comparison only
};
const std::vector<SolverEntry>& solver_registry();
/// Finds a solver by its name. Throws InputError for an unknown name, and suggests the nearest one.
const SolverEntry& find_solver(const std::string& name);
const SolverEntry& find_solver(SolverName name);

/// Throws InputError where the solver does not take the law. The message names the solver's laws and the solvers that
/// take this law.
void demand_law(const SolverEntry& entry, Law law);

/// Throws InputError where the solver or the law does not support rolling and spinning friction. The message names what
/// is allowed.
void demand_moments(const SolverEntry& entry, Law law);

}  // namespace nilas::contact
