#include "contact/registry.h"

#include <algorithm>
#include <charconv>

#include "contact/solvers/admm.h"
#include "contact/solvers/apgd.h"
#include "contact/solvers/auto.h"
#include "contact/solvers/eg.h"
#include "contact/solvers/enumerate.h"
#include "contact/solvers/ipm.h"
#include "contact/solvers/newton.h"
#include "contact/solvers/newton_order_free.h"
#include "contact/solvers/nsgs.h"
#include "contact/solvers/pgs.h"
#ifdef NILAS_PEER_SOLVERS
#include "contact/peers/siconos.h"
#include "contact/peers/simbody_pgs.h"
#endif
#include "core/base/error.h"

namespace nilas {

/// Bounds of pyramid-k; at the upper one its friction is within 5e-6 of the cone's.
constexpr int k_fewest_facets = 3;
constexpr int k_most_facets = 1000;

template <class Solver, class Settings>
static std::unique_ptr<ContactSolver> make(const SolverSettings& shared) {
  Settings settings;
  settings.shared = shared;
  return std::make_unique<Solver>(settings);
}

static std::unique_ptr<ContactSolver> make_order_free(const SolverSettings& shared) {
  return std::make_unique<EgSolver>(EgSettings{.shared = shared, .order_free = true});
}

static std::unique_ptr<ContactSolver> make_order_free_newton(const SolverSettings& shared) {
  return std::make_unique<OrderFreeNewtonSolver>(shared);
}

#ifdef NILAS_PEER_SOLVERS
template <SiconosMethod method>
static std::unique_ptr<ContactSolver> make_siconos(const SolverSettings& shared) {
  return std::make_unique<SiconosSolver>(SiconosSettings{.shared = shared, .method = method});
}
#endif

const std::vector<SolverEntry>& solver_registry() {
  static const std::vector<Law> pgs_laws{Law::pyramid, Law::coulomb, Law::frictionless};
  static const std::vector<Law> all_laws{Law::coulomb, Law::ccp, Law::pyramid, Law::pyramid_k, Law::frictionless};
  static const std::vector<Law> cone_laws{Law::coulomb, Law::ccp, Law::frictionless};
  static const std::vector<Law> convex_sets{Law::coulomb, Law::ccp, Law::pyramid_k, Law::frictionless};
  static const std::vector<SolverEntry> entries{
      {"pgs",
       "Projected Gauss-Seidel on single rows, about 25 ns per contact and sweep; for loose packings and comparison "
       "with earlier tools, slow for stacks and heavy-on-light contact.",
       pgs_laws, make<PgsSolver, PgsSettings>},
      {"nsgs",
       "Block Gauss-Seidel with the exact solution of each contact, 1.3 to 1.7 times the cost of a sweep of pgs; for "
       "loose fields and as a first stage, slow for stacks and heavy-on-light contact.",
       all_laws, make<NsgsSolver, NsgsSettings>, true},
      {"eg",
       "Self-adaptive extragradient, two products with W per iteration, O(contacts); for sliding fields, slow for "
       "stacks and redundant contacts.",
       convex_sets, make<EgSolver, EgSettings>},
      {"eg-order-free",
       "eg with exact cuts of every sum: mirror images, permuted bodies and contacts and any number of threads give "
       "the same bits, at about twice the cost of eg; for sliding fields, newton-order-free elsewhere.",
       convex_sets, make_order_free, false, true},
      {"apgd",
       "Accelerated projected gradient with De Saxce's outer loop, one product with W per iteration, O(contacts); 100 "
       "to 20000 iterations; for mass ratios and fields where 1e-8 m/s is enough, may stall at 1e-5 m/s on tall "
       "stacks.",
       convex_sets, make<ApgdSolver, ApgdSettings>},
      {"enumerate",
       "Tries every combination of open, sticking and slipping of up to 8 contacts, 3^n dense systems; an oracle to "
       "check others by.",
       cone_laws, make<EnumerateSolver, EnumerateSettings>},
      {"admm",
       "Alternating directions with De Saxce's shift; few factorisations, two triangular solves per iteration, 30 to "
       "1000 iterations; for sticking contact of any masses, stalls where slipping contacts are redundant.",
       cone_laws, make<AdmmSolver, AdmmSettings>},
      {"ipm",
       "Interior point with a De Saxce outer loop and a Newton finish; 10 to 200 factorisations whatever the masses; "
       "for extreme mass ratios, stacks and redundant contacts, costly for large loose fields.",
       cone_laws, make<IpmSolver, IpmSettings>},
      {"newton",
       "Proximal semismooth Newton, one sparse factorisation of the loaded contacts per iteration, 5 to 30 iterations; "
       "the reference: for accuracy, stacks, jams, redundant contacts and mass ratios.",
       all_laws, make<NewtonSolver, NewtonSettings>},
      {"newton-order-free",
       "newton whose steps are solved to many more digits than are kept: mirror images, permuted bodies and contacts "
       "and any number of threads give the same bits, at one to three times the cost of newton; the first choice for "
       "studies of symmetry.",
       convex_sets, make_order_free_newton, false, true},
      {"auto",
       "Climbs from nsgs over admm and newton to ipm until the tolerance holds, island by island, and says what it "
       "used; the "
       "default for every problem.",
       all_laws, make<AutoSolver, AutoSettings>, true},
#ifdef NILAS_PEER_SOLVERS
      {"siconos-nsgs",
       "Siconos' block Gauss-Seidel, run down a ladder of its own relative tolerances; for comparison only.",
       {Law::coulomb},
       make_siconos<SiconosMethod::nsgs>},
      {"siconos-nsn-ac",
       "Siconos' semismooth Newton on the function of Alart and Curnier, run likewise; for comparison only.",
       {Law::coulomb},
       make_siconos<SiconosMethod::nsn_ac>},
      {"siconos-prox",
       "Siconos' proximal point with that Newton inside, run likewise; for comparison only.",
       {Law::coulomb},
       make_siconos<SiconosMethod::prox>},
      {"siconos-admm",
       "Siconos' alternating directions, run likewise; for comparison only.",
       {Law::coulomb},
       make_siconos<SiconosMethod::admm>},
      {"simbody-pgs",
       "Simbody's over-relaxed projected Gauss-Seidel on a dense W, up to 1000 contacts; for comparison only.",
       {Law::coulomb},
       make<SimbodyPgsSolver, SimbodyPgsSettings>},
#endif
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

void demand_law(const SolverEntry& entry, Law law) {
  const auto takes = [law](const SolverEntry& other) {
    return std::find(other.laws.begin(), other.laws.end(), law) != other.laws.end();
  };
  if (takes(entry)) return;
  std::string laws, others;
  for (const Law known : entry.laws) laws += (laws.empty() ? "" : ", ") + std::string(to_string(known));
  for (const auto& other : solver_registry())
    if (takes(other)) others += (others.empty() ? "" : ", ") + other.name;
  throw InputError("solver '" + entry.name + "' does not take the law '" + to_string(law) + "'; it takes: " + laws +
                   "; solvers for this law: " + others);
}

void demand_moments(const SolverEntry& entry, Law law) {
  std::string solvers;
  for (const auto& other : solver_registry())
    if (other.moments) solvers += (solvers.empty() ? "" : ", ") + other.name;
  if (!entry.moments)
    throw InputError("solver '" + entry.name + "' does not take rolling and spinning friction; these do: " + solvers);
  if (law != Law::coulomb && law != Law::pyramid && law != Law::frictionless)
    throw InputError("rolling and spinning friction go with the laws coulomb, pyramid and frictionless, not with '" +
                     std::string(to_string(law)) + "'");
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
