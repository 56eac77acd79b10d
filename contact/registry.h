#pragma once
/// Solvers by name: what `nilas solvers` lists and what a scene may ask for.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/solvers/solver.h"
#include "core/choices/solver_name.h"

namespace nilas {

struct SolverEntry {
  std::string name;
  std::string summary;  ///< one sentence: what it is, cost per iteration, when to use
  std::vector<Law> laws;
  std::function<std::unique_ptr<ContactSolver>(const SolverSettings&)> make;
  bool moments = false;                      ///< see SolverTraits
  bool order_free = false;                   ///< see SolverTraits
  std::optional<SolverName> in_scenes = {};  ///< how a scene asks for it; none of those for comparison only
};
const std::vector<SolverEntry>& solver_registry();
/// Throws InputError naming the nearest solver.
const SolverEntry& find_solver(const std::string& name);
const SolverEntry& find_solver(SolverName name);

/// Throws InputError naming the solver's laws, and the solvers that take this one, where the entry does not.
void demand_law(const SolverEntry& entry, Law law);

/// Throws InputError naming what is allowed where solver or law does not go with rolling and spinning friction.
void demand_moments(const SolverEntry& entry, Law law);

}  // namespace nilas
