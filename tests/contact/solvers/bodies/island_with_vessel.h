#pragma once
/// A heap in which one body is a vessel of nine speeds, so that it takes two nodes.
#include <algorithm>

#include "contact/problem/islands.h"
#include "contact/problem/prepared_problem.h"
#include "core/base/random.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::test {

/// Adds a block of nine speeds with contacts to every second body of a random heap.
inline contact::ContactProblem heap_with_vessel(std::uint64_t seed, int bodies, int contacts, double mu) {
  contact::ContactProblem problem = random_heap(seed, bodies, contacts, mu);
  RandomStream random(seed, "vessel");
  const auto random_matrix = [&](int rows, int columns) {
    MatX out(rows, columns);
    for (Eigen::Index i = 0; i < out.size(); ++i) out.data()[i] = random.normal();
    return out;
  };
  const MatX root = random_matrix(9, 9);
  const int vessel = problem.add_block(root * root.transpose() + 20 * MatX::Identity(9, 9));
  problem.f.tail(9) = 30 * random_matrix(9, 1);
  for (int k = 0; k < bodies; k += 2) {
    const int c = problem.add_contact(k, random_matrix(3, 6), vessel, random_matrix(3, 9), 1000 + k);
    problem.mu[c] = problem.mu_static[c] = mu;
  }
  return problem;
}

/// The largest island of a problem.
inline contact::ContactProblem largest_island(const contact::ContactProblem& problem) {
  const auto islands = contact::find_islands(problem);
  const auto largest = std::max_element(islands.begin(), islands.end(),
                                        [](const auto& a, const auto& b) { return a.size() < b.size(); });
  return contact::select(problem, *largest);
}

}  // namespace nilas::test
