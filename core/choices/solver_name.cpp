#include "core/choices/solver_name.h"

#include <algorithm>

namespace nilas {

bool SolverTraits::takes(Law law) const { return std::find(laws.begin(), laws.end(), law) != laws.end(); }

SolverTraits traits_of(SolverName solver) {
  static const std::vector<Law> all{Law::coulomb, Law::ccp, Law::pyramid, Law::pyramid_k, Law::frictionless};
  static const std::vector<Law> rows{Law::pyramid, Law::coulomb, Law::frictionless};
  static const std::vector<Law> cones{Law::coulomb, Law::ccp, Law::frictionless};
  static const std::vector<Law> convex_sets{Law::coulomb, Law::ccp, Law::pyramid_k, Law::frictionless};
  switch (solver) {
    case SolverName::pgs:
      return {rows};
    case SolverName::nsgs:
      return {.laws = all, .moments = true};
    case SolverName::eg:
    case SolverName::apgd:
      return {convex_sets};
    case SolverName::eg_order_free:
    case SolverName::newton_order_free:
      return {.laws = convex_sets, .order_free = true};
    case SolverName::enumerate:
    case SolverName::admm:
    case SolverName::ipm:
      return {cones};
    case SolverName::newton:
      return {all};
    case SolverName::automatic:
      return {.laws = all, .moments = true};
  }
  return {};
}

static void append(std::string& list, const std::string& word) { list += (list.empty() ? "" : ", ") + word; }

std::optional<std::string> law_problem(SolverName solver, Law law) {
  const SolverTraits traits = traits_of(solver);
  if (traits.takes(law)) return std::nullopt;
  std::string laws, others;
  for (const Law known : traits.laws) append(laws, name_of(known));
  for (const SolverName other : all_choices<SolverName>())
    if (traits_of(other).takes(law)) append(others, name_of(other));
  return "solver '" + name_of(solver) + "' does not take the law '" + name_of(law) + "'; it takes: " + laws +
         "; solvers for this law: " + others;
}

std::optional<std::string> moment_problem(SolverName solver, Law law) {
  if (!traits_of(solver).moments) {
    std::string solvers;
    for (const SolverName other : all_choices<SolverName>())
      if (traits_of(other).moments) append(solvers, name_of(other));
    return "solver '" + name_of(solver) + "' does not take rolling and spinning friction; these do: " + solvers;
  }
  if (law != Law::coulomb && law != Law::pyramid && law != Law::frictionless)
    return "rolling and spinning friction go with the laws coulomb, pyramid and frictionless, not with '" +
           name_of(law) + "'";
  return std::nullopt;
}

}  // namespace nilas
