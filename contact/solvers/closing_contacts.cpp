#include "contact/solvers/closing_contacts.h"

#include <algorithm>
#include <utility>

#include "contact/law/law_map.h"
#include "contact/problem/islands.h"
#include "contact/problem/operators.h"
#include "contact/problem/row_of.h"
#include "contact/solvers/solver.h"
#include "core/base/union_find.h"

namespace nilas::solvers {

namespace {

using Islands = std::vector<std::vector<int>>;

/// Contacts of an island from which on it is looked at.
constexpr std::size_t k_least_contacts = 200;
/// Share of the island's contacts that may hang together.
constexpr double k_most_together = 0.1;
/// A chain of floes that hit each other one after the other needs a round for each; the whole island needs none.
constexpr int k_most_parting_rounds = 20;

/// law_map of each contact [m/s].
std::vector<double> law_maps(const contact::PreparedProblem& whole, const VecX& r) {
  const contact::ContactProblem& problem = whole.problem();
  const VecX v = contact::velocities(whole, r);
  std::vector<double> maps;
  maps.reserve(static_cast<std::size_t>(problem.num_contacts()));
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const double d = whole.inverse_mass_scales()[c];
    const Vec3 r_c = r.segment<3>(contact::row_of(c));
    const Vec3 u = contact::compliant_velocity(problem, c, r_c, contact::contact_velocity(problem, c, v.data()));
    maps.push_back(contact::law_map(problem.law, problem.facets, contact::contact_scale(problem, c, d), r_c, u));
  }
  return maps;
}

Islands unsolved(Islands islands, const std::vector<double>& maps, double tolerance) {
  const auto is_solved = [&](int c) { return maps[c] <= tolerance; };
  std::erase_if(islands,
                [&](const std::vector<int>& island) { return std::all_of(island.begin(), island.end(), is_solved); });
  return islands;
}

std::size_t largest(const Islands& islands) {
  std::size_t most = 0;
  for (const auto& island : islands) most = std::max(most, island.size());
  return most;
}

/// Marks the contacts that cannot be left out. Returns whether any was not marked before.
bool mark_closing(const VecX& r, const std::vector<double>& maps, std::vector<char>& closes) {
  bool is_new = false;
  for (std::size_t c = 0; c < maps.size(); ++c) {
    if (closes[c] != 0 || (maps[c] <= 0 && r.segment<3>(contact::row_of(c)).isZero(0))) continue;
    closes[c] = 1;
    is_new = true;
  }
  return is_new;
}

/// The islands that the marked contacts form.
Islands islands_of(const contact::ContactProblem& problem, const std::vector<char>& closes) {
  std::vector<int> closing;
  std::vector<std::size_t> block_of;
  UnionFind blocks(static_cast<std::size_t>(problem.num_blocks()));
  for (int c = 0; c < problem.num_contacts(); ++c) {
    if (closes[c] == 0) continue;
    const auto& pair = problem.pairs[c];
    if (pair.a >= 0 && pair.b >= 0) blocks.join(pair.a, pair.b);
    const int any = std::max(pair.a, pair.b);
    closing.push_back(c);
    block_of.push_back(any >= 0 ? static_cast<std::size_t>(any) : UnionFind::k_nothing);
  }
  Islands islands = blocks.groups_of(block_of);
  for (auto& island : islands)
    for (int& c : island) c = closing[c];
  return islands;
}

bool falls_apart(std::size_t together, std::size_t contacts) {
  return static_cast<double>(together) <= k_most_together * static_cast<double>(contacts);
}

/// For each island the most closing contacts that hang together.
std::vector<std::size_t> largest_parts(const contact::ContactProblem& problem, const Islands& islands, const VecX& r,
                                       const std::vector<double>& maps) {
  std::vector<char> closes(maps.size());
  mark_closing(r, maps, closes);
  std::vector<std::size_t> island_of(maps.size(), islands.size());
  for (std::size_t k = 0; k < islands.size(); ++k)
    for (const int c : islands[k]) island_of[c] = k;
  std::vector<std::size_t> most(islands.size() + 1, 0);  // the last for contacts of solved islands
  for (const auto& part : islands_of(problem, closes)) {
    std::size_t& here = most[island_of[part.front()]];
    here = std::max(here, part.size());
  }
  return most;
}

void put(const VecX& part, const std::vector<int>& contacts, VecX& r) {
  for (std::size_t i = 0; i < contacts.size(); ++i)
    r.segment<3>(contact::row_of(contacts[i])) = part.segment<3>(contact::row_of(i));
}

/// What the rounds of one island took.
struct Rounds {
  int iterations = 0;
  std::vector<double> history;
};

/// The rounds of one island. Leaves the impulses with the least residual.
Rounds solve_apart(const contact::PreparedProblem& island, double tolerance, const PartSolve& solve, VecX& best) {
  Rounds rounds;
  const contact::ContactProblem& problem = island.problem();
  VecX r = best;
  std::vector<double> maps = law_maps(island, r);
  double least = *std::max_element(maps.begin(), maps.end());
  std::vector<char> closes(maps.size());
  bool goes_on = true;
  for (int round = 0; goes_on && round < k_most_parting_rounds && mark_closing(r, maps, closes); ++round) {
    const Islands parts = unsolved(islands_of(problem, closes), maps, tolerance);
    if (parts.empty() || !falls_apart(largest(parts), maps.size())) break;
    std::vector<int> contacts;
    for (const auto& part : parts) contacts.insert(contacts.end(), part.begin(), part.end());
    std::sort(contacts.begin(), contacts.end());
    const contact::ContactProblem part = contact::select(problem, contacts);
    const contact::ContactSolution found =
        solve(contact::PreparedProblem(part), impulses_of(r, contacts), rounds.iterations);
    rounds.iterations += found.iterations;
    rounds.history.insert(rounds.history.end(), found.history.begin(), found.history.end());
    put(found.r, contacts, r);
    if (!r.allFinite()) break;
    maps = law_maps(island, r);
    if (const double map = *std::max_element(maps.begin(), maps.end()); map <= least) {
      least = map;
      best = r;
    }
    goes_on = found.status == contact::SolveStatus::converged;
  }
  return rounds;
}

}  // namespace

std::vector<char> closing_contacts(const contact::PreparedProblem& problem, const VecX& r) {
  std::vector<char> closes(static_cast<std::size_t>(problem.problem().num_contacts()));
  mark_closing(r, law_maps(problem, r), closes);
  return closes;
}

VecX impulses_of(const VecX& r, const std::vector<int>& contacts) {
  VecX out(contact::row_of(contacts.size()));
  for (std::size_t i = 0; i < contacts.size(); ++i)
    out.segment<3>(contact::row_of(i)) = r.segment<3>(contact::row_of(contacts[i]));
  return out;
}

ClosingOutcome solve_closing(const contact::PreparedProblem& whole, double tolerance, const PartSolve& solve, VecX& r) {
  const contact::ContactProblem& problem = whole.problem();
  const std::vector<double> maps = law_maps(whole, r);
  ClosingOutcome outcome{unsolved(whole.islands(), maps, tolerance), 0, {}};
  const Islands& islands = outcome.unsolved;
  if (largest(islands) < k_least_contacts || !r.allFinite()) return outcome;
  const std::vector<std::size_t> together = largest_parts(problem, islands, r, maps);
  bool is_changed = false;
  for (std::size_t k = 0; k < islands.size(); ++k) {
    const std::vector<int>& island = islands[k];
    if (island.size() < k_least_contacts || !falls_apart(together[k], island.size())) continue;
    const contact::ContactProblem part = contact::select(problem, island);
    VecX r_part = impulses_of(r, island);
    const Rounds rounds = solve_apart(contact::PreparedProblem(part), tolerance, solve, r_part);
    outcome.iterations = std::max(outcome.iterations, rounds.iterations);
    merge_history(rounds.history, outcome.history);
    put(r_part, island, r);
    is_changed = true;
  }
  if (is_changed) outcome.unsolved = unsolved(whole.islands(), law_maps(whole, r), tolerance);
  return outcome;
}

}  // namespace nilas::solvers
