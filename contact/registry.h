#pragma once
/// Solvers by name: what `nilas solvers` lists and what a scene may ask for.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "contact/solvers/solver.h"

namespace nilas {

struct SolverEntry {
  std::string name;
  std::string summary;  ///< one sentence: what it is, cost per iteration, when to use
  std::vector<Law> laws;
  std::function<std::unique_ptr<ContactSolver>(const SolverSettings&)> make;
  bool moments = false;  ///< takes rolling and spinning friction, with the laws coulomb and pyramid
  /// The bits depend neither on the order of contacts and bodies nor, but for the sign, on a mirror.
  bool order_free = false;
};
const std::vector<SolverEntry>& solver_registry();
/// Throws InputError naming the nearest solver.
const SolverEntry& find_solver(const std::string& name);

/// Throws InputError naming the solver's laws, and the solvers that take this one, where the entry does not.
void demand_law(const SolverEntry& entry, Law law);

/// Throws InputError naming what is allowed where solver or law does not go with rolling and spinning friction.
void demand_moments(const SolverEntry& entry, Law law);

/// "pyramid-8" gives pyramid_k with 8 facets. Throws InputError naming the nearest law.
struct ParsedLaw {
  Law law = Law::coulomb;
  int facets = 0;
};
ParsedLaw parse_law(const std::string& name);

}  // namespace nilas
