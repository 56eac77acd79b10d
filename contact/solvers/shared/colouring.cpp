#include "contact/solvers/shared/colouring.h"

#include <bit>
#include <cstdint>

namespace nilas::solvers {

namespace {

constexpr int k_most_colours = 64;  ///< one bit each

/// Contacts [first, last) of the list, all between the same blocks.
struct Run {
  int first = 0, last = 0;
};

std::vector<Run> find_runs(const contact::ContactProblem& problem, const std::vector<int>& contacts) {
  std::vector<Run> runs;
  const auto pair = [&](int k) -> const contact::ContactProblem::Pair& { return problem.pairs[contacts[k]]; };
  for (int k = 0; k < static_cast<int>(contacts.size()); ++k) {
    if (!runs.empty() && pair(k).a == pair(runs.back().first).a && pair(k).b == pair(runs.back().first).b)
      runs.back().last = k + 1;
    else
      runs.push_back({k, k + 1});
  }
  return runs;
}

}  // namespace

void colour(const contact::ContactProblem& problem, std::vector<int>& contacts, int first, std::vector<int>& runs,
            std::vector<int>& colours) {
  const std::vector<Run> found = find_runs(problem, contacts);
  const auto blocks_of = [&](const Run& run) { return problem.pairs[contacts[run.first]]; };
  std::vector<int> neighbours(static_cast<std::size_t>(problem.num_blocks()), 0);
  for (const Run& run : found)
    for (const int k : {blocks_of(run).a, blocks_of(run).b})
      if (k >= 0) ++neighbours[k];
  // greedy colours never exceed the neighbours of both blocks together
  const auto is_crowded = [&](int k) { return k >= 0 && 2 * neighbours[k] > k_most_colours; };

  std::vector<std::uint64_t> used(neighbours.size(), 0);
  std::vector<std::vector<Run>> by_colour;
  std::vector<Run> in_turn;
  for (const Run& run : found) {
    const auto& [a, b] = blocks_of(run);
    if (is_crowded(a) || is_crowded(b)) {
      in_turn.push_back(run);
      continue;
    }
    std::uint64_t taken = 0;
    for (const int k : {a, b})
      if (k >= 0) taken |= used[k];
    const auto free = static_cast<std::size_t>(std::countr_one(taken));
    for (const int k : {a, b})
      if (k >= 0) used[k] |= std::uint64_t{1} << free;
    if (by_colour.size() <= free) by_colour.resize(free + 1);
    by_colour[free].push_back(run);
  }

  std::vector<int> ordered;
  ordered.reserve(contacts.size());
  const auto append = [&](const Run& run) {
    ordered.insert(ordered.end(), contacts.begin() + run.first, contacts.begin() + run.last);
  };
  runs.clear();
  colours.clear();
  for (const auto& members : by_colour) {
    colours.push_back(static_cast<int>(runs.size()));
    for (const Run& run : members) {
      runs.push_back(first + static_cast<int>(ordered.size()));
      append(run);
    }
  }
  colours.push_back(static_cast<int>(runs.size()));
  runs.push_back(first + static_cast<int>(ordered.size()));
  for (const Run& run : in_turn) append(run);
  contacts = std::move(ordered);
}

}  // namespace nilas::solvers
