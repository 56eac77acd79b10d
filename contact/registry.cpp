#include "contact/registry.h"

#include <algorithm>
#include <charconv>

#include "contact/solvers/pgs.h"
#include "core/base/error.h"

namespace nilas {

/// Bounds of pyramid-k; at the upper one its friction is within 5e-6 of the cone's.
constexpr int k_fewest_facets = 3;
constexpr int k_most_facets = 1000;

static std::unique_ptr<ContactSolver> make_pgs(const SolverSettings& settings) {
  return std::make_unique<PgsSolver>(PgsSettings{.shared = settings});
}

const std::vector<SolverEntry>& solver_registry() {
  static const std::vector<Law> pgs_laws{Law::pyramid, Law::coulomb, Law::frictionless};
  static const std::vector<SolverEntry> entries{
      {"pgs",
       "Projected Gauss-Seidel on single rows, about 25 ns per contact and sweep; for loose packings and comparison "
       "with "
       "earlier tools, slow for stacks and heavy-on-light contact.",
       pgs_laws, make_pgs},
      {"auto", "Picks a solver for the problem; in this version it is pgs, whatever the problem.", pgs_laws, make_pgs},
  };
  return entries;
}

static std::string suggestion(const std::string& name, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(name, known);
  std::string all;
  for (const auto& word : known) all += (all.empty() ? "" : ", ") + word;
  return (nearest.empty() ? "" : "; did you mean '" + nearest + "'?") + std::string(" known: ") + all;
}

const SolverEntry& find_solver(const std::string& name) {
  std::vector<std::string> known;
  for (const auto& entry : solver_registry()) {
    if (entry.name == name) return entry;
    known.push_back(entry.name);
  }
  throw InputError("unknown contact solver '" + name + "'" + suggestion(name, known));
}

const char* to_string(Law law) {
  switch (law) {
    case Law::coulomb:
      return "coulomb";
    case Law::ccp:
      return "ccp";
    case Law::pyramid:
      return "pyramid";
    case Law::pyramid_k:
      return "pyramid-k";
    case Law::frictionless:
      return "frictionless";
  }
  return "unknown";
}

/// The k of "pyramid-k", 0 when the name has another form.
static int parse_facets(const std::string& name) {
  const std::string stem = "pyramid-";
  if (name.rfind(stem, 0) != 0) return 0;
  int facets = 0;
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data() + stem.size(), end, facets);
  return error == std::errc() && stop == end ? facets : 0;
}

ParsedLaw parse_law(const std::string& name) {
  for (const Law law : {Law::coulomb, Law::ccp, Law::pyramid, Law::frictionless})
    if (name == to_string(law)) return {law, 0};
  const int facets = parse_facets(name);
  if (facets >= k_fewest_facets && facets <= k_most_facets) return {Law::pyramid_k, facets};
  if (facets != 0 || name == to_string(Law::pyramid_k))
    throw InputError("contact law '" + name + "': a pyramid has " + std::to_string(k_fewest_facets) + " to " +
                     std::to_string(k_most_facets) + " facets, e.g. pyramid-8");
  throw InputError("unknown contact law '" + name + "'" +
                   suggestion(name, {"coulomb", "ccp", "pyramid", "pyramid-8", "frictionless"}));
}

}  // namespace nilas
