#include "contact/registry.h"

#include <algorithm>

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

namespace nilas::contact {

template <class Solver, class Settings>
static std::unique_ptr<solvers::ContactSolver> make(const SolverSettings& shared) {
  Settings settings;
  settings.shared = shared;
  return std::make_unique<Solver>(settings);
}

static std::unique_ptr<solvers::ContactSolver> make_order_free(const SolverSettings& shared) {
  return std::make_unique<solvers::EgSolver>(solvers::EgSettings{.shared = shared, .order_free = true});
}

static std::unique_ptr<solvers::ContactSolver> make_order_free_newton(const SolverSettings& shared) {
  return std::make_unique<solvers::OrderFreeNewtonSolver>(shared);
}

#ifdef NILAS_PEER_SOLVERS
template <SiconosMethod method>
static std::unique_ptr<solvers::ContactSolver> make_siconos(const SolverSettings& shared) {
  return std::make_unique<SiconosSolver>(SiconosSettings{.shared = shared, .method = method});
}
#endif

/// Builds the solver that a scene asks for by this name.
static std::unique_ptr<solvers::ContactSolver> make_named(SolverName name, const SolverSettings& settings) {
  switch (name) {
    case SolverName::pgs:
      return make<solvers::PgsSolver, solvers::PgsSettings>(settings);
    case SolverName::nsgs:
      return make<solvers::NsgsSolver, solvers::NsgsSettings>(settings);
    case SolverName::eg:
      return make<solvers::EgSolver, solvers::EgSettings>(settings);
    case SolverName::eg_order_free:
      return make_order_free(settings);
    case SolverName::apgd:
      return make<solvers::ApgdSolver, solvers::ApgdSettings>(settings);
    case SolverName::enumerate:
      return make<solvers::EnumerateSolver, solvers::EnumerateSettings>(settings);
    case SolverName::admm:
      return make<solvers::AdmmSolver, solvers::AdmmSettings>(settings);
    case SolverName::ipm:
      return make<solvers::IpmSolver, solvers::IpmSettings>(settings);
    case SolverName::newton:
      return make<solvers::NewtonSolver, solvers::NewtonSettings>(settings);
    case SolverName::newton_order_free:
      return make_order_free_newton(settings);
    case SolverName::automatic:
      return make<solvers::AutoSolver, solvers::AutoSettings>(settings);
  }
  return nullptr;
}

static SolverEntry entry_of(SolverName name) {
  const SolverFacts facts = facts_of(name);
  const auto make_it = [name](const SolverSettings& settings) { return make_named(name, settings); };
  return {std::string(facts.text.name),
          std::string(facts.text.doc),
          {facts.laws.begin(), facts.laws.end()},
          make_it,
          facts.moments,
          facts.order_free,
          name};
}

/// The solvers of other projects, where this build has them.
static std::vector<SolverEntry> peer_entries() {
  return {
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
}

const std::vector<SolverEntry>& solver_registry() {
  static const std::vector<SolverEntry> entries = [] {
    std::vector<SolverEntry> all;
    for (const SolverName name : all_choices<SolverName>()) all.push_back(entry_of(name));
    for (SolverEntry& peer : peer_entries()) all.push_back(std::move(peer));
    return all;
  }();
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

const SolverEntry& find_solver(SolverName name) {
  return solver_registry().at(
      static_cast<std::size_t>(name));  // the registry begins with the solvers of scenes, in the order of SolverName
}

void demand_law(const SolverEntry& entry, Law law) {
  if (entry.in_scenes) {
    if (const auto problem = law_problem(*entry.in_scenes, law)) throw InputError(*problem);
    return;
  }
  if (std::find(entry.laws.begin(), entry.laws.end(), law) != entry.laws.end()) return;
  std::string laws;
  for (const Law known : entry.laws) laws += (laws.empty() ? "" : ", ") + name_of(known);
  throw InputError("solver '" + entry.name + "' does not take the law '" + name_of(law) + "'; it takes: " + laws);
}

void demand_moments(const SolverEntry& entry, Law law) {
  const auto problem = entry.in_scenes
                           ? moment_problem(*entry.in_scenes, law)
                           : std::optional("solver '" + entry.name + "' does not take rolling and spinning friction");
  if (problem) throw InputError(*problem);
}

}  // namespace nilas::contact
