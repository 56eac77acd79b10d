#include "contact/islands.h"

#include <numeric>

namespace nilas {

/// Root of k's tree; halves the path on the way.
static int root_of(std::vector<int>& parent, int k) {
  auto at = [&](int i) -> int& { return parent[static_cast<std::size_t>(i)]; };
  while (at(k) != k) {
    at(k) = at(at(k));
    k = at(k);
  }
  return k;
}

std::vector<std::vector<int>> find_islands(const ContactProblem& problem) {
  std::vector<int> parent(static_cast<std::size_t>(problem.num_blocks()));
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& pair : problem.pairs)
    if (pair.a >= 0 && pair.b >= 0) parent[static_cast<std::size_t>(root_of(parent, pair.b))] = root_of(parent, pair.a);

  std::vector<std::vector<int>> islands;
  std::vector<int> island_of_root(parent.size(), -1);
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const auto& pair = problem.pairs[static_cast<std::size_t>(c)];
    const int block = pair.a >= 0 ? pair.a : pair.b;
    if (block < 0) {  // nothing here can move: an island of its own
      islands.push_back({c});
      continue;
    }
    int& island = island_of_root[static_cast<std::size_t>(root_of(parent, block))];
    if (island < 0) {
      island = static_cast<int>(islands.size());
      islands.emplace_back();
    }
    islands[static_cast<std::size_t>(island)].push_back(c);
  }
  return islands;
}

}  // namespace nilas
