#include "core/choices/solver_name.h"

namespace nilas {

static void append(std::string& list, const std::string& word) { list += (list.empty() ? "" : ", ") + word; }

std::optional<std::string> law_problem(SolverName solver, Law law) {
  const SolverFacts facts = facts_of(solver);
  if (facts.takes(law)) return std::nullopt;
  std::string laws, others;
  for (const Law known : facts.laws) append(laws, name_of(known));
  for (const SolverName other : all_choices<SolverName>())
    if (facts_of(other).takes(law)) append(others, name_of(other));
  return "solver '" + name_of(solver) + "' does not take the law '" + name_of(law) + "'; it takes: " + laws +
         "; solvers for this law: " + others;
}

std::optional<std::string> moment_problem(SolverName solver, Law law) {
  if (!facts_of(solver).moments) {
    std::string solvers;
    for (const SolverName other : all_choices<SolverName>())
      if (facts_of(other).moments) append(solvers, name_of(other));
    return "solver '" + name_of(solver) + "' does not take rolling and spinning friction; these do: " + solvers;
  }
  if (law != Law::coulomb && law != Law::pyramid && law != Law::frictionless)
    return "rolling and spinning friction go with the laws coulomb, pyramid and frictionless, not with '" +
           name_of(law) + "'";
  return std::nullopt;
}

}  // namespace nilas
