#include "contact/problem/islands.h"

#include <algorithm>
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

ContactProblem select(const ContactProblem& problem, const std::vector<int>& contacts) {
  ContactProblem part;
  part.h = problem.h;
  part.law = problem.law;
  part.facets = problem.facets;
  std::vector<int> place(static_cast<std::size_t>(problem.num_blocks()), -1);
  for (const int c : contacts)
    for (const int k : {problem.pairs[static_cast<std::size_t>(c)].a, problem.pairs[static_cast<std::size_t>(c)].b})
      if (k >= 0) place[static_cast<std::size_t>(k)] = 0;
  std::vector<double> momenta;
  for (int k = 0; k < problem.num_blocks(); ++k) {
    if (place[static_cast<std::size_t>(k)] < 0) continue;
    place[static_cast<std::size_t>(k)] = part.num_blocks();
    const auto mass = problem.mass(k);
    part.mass_data.insert(part.mass_data.end(), mass.data(), mass.data() + mass.size());
    part.mass_offset.push_back(part.mass_data.size());
    part.block_offset.push_back(part.block_offset.back() + problem.block_size(k));
    const double* const first = problem.f.data() + problem.block_offset[static_cast<std::size_t>(k)];
    momenta.insert(momenta.end(), first, first + problem.block_size(k));
  }
  part.f = Eigen::Map<const VecX>(momenta.data(), static_cast<Eigen::Index>(momenta.size()));
  part.w.resize(3 * static_cast<Eigen::Index>(contacts.size()));
  for (const int c : contacts) {
    const auto i = static_cast<std::size_t>(c);
    const auto placed = [&](int k) { return k < 0 ? -1 : place[static_cast<std::size_t>(k)]; };
    part.w.segment<3>(3 * static_cast<Eigen::Index>(part.pairs.size())) =
        problem.w.segment<3>(3 * static_cast<Eigen::Index>(c));
    part.pairs.push_back({placed(problem.pairs[i].a), placed(problem.pairs[i].b)});
    const auto rows = problem.jacobian_data.begin();
    part.jacobian_data.insert(part.jacobian_data.end(), rows + static_cast<std::ptrdiff_t>(problem.jacobian_offset[i]),
                              rows + static_cast<std::ptrdiff_t>(problem.jacobian_offset[i + 1]));
    part.jacobian_offset.push_back(part.jacobian_data.size());
    part.mu.push_back(problem.mu[i]);
    part.mu_static.push_back(problem.mu_static[i]);
    part.force_limit.push_back(problem.force_limit[i]);
    part.compliance.push_back(problem.compliance[i]);
    part.key.push_back(problem.key[i]);
  }
  if (problem.has_moments()) {
    const auto placed = [&](int c) {
      return c < 0 ? -1 : static_cast<int>(std::lower_bound(contacts.begin(), contacts.end(), c) - contacts.begin());
    };
    for (const int c : contacts) {
      const auto& moment = problem.moments[static_cast<std::size_t>(c)];
      part.moments.push_back({placed(moment.contact), placed(moment.moment), moment.rolling});
    }
  }
  return part;
}

}  // namespace nilas
