#pragma once
/// Contacts of an island in colours: within one colour no two share a moving block, so they may be visited at once and
/// the sweep's bits do not depend on the number of threads.
#include <cstddef>
#include <vector>

#include "contact/problem/problem.h"

namespace nilas::solvers {

/// Smaller islands are swept faster in turn than with threads that wait for each other.
constexpr std::size_t k_fewest_coloured = 1000;

/// Reorders `contacts` (of one island): runs of contacts between the same two blocks, greedily coloured, then the
/// contacts of blocks with too many neighbours (a vessel) in turn. `runs`, `colours` as in PgsIsland, places counted
/// from `first`.
void colour(const contact::ContactProblem& problem, std::vector<int>& contacts, int first, std::vector<int>& runs,
            std::vector<int>& colours);

}  // namespace nilas::solvers
