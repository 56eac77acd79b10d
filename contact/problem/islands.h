#pragma once
/// Groups of contacts that share no moving block: each can be solved apart.
#include <vector>

#include "contact/problem/local_problem.h"
#include "contact/problem/problem.h"

namespace nilas::contact {

/// Contact indices per island, rising inside, islands ordered by their first contact.
std::vector<std::vector<int>> find_islands(const ContactProblem& problem);
/// The same for a local problem, whose contacts are joined by blocks of W that are not zero.
std::vector<std::vector<int>> find_islands(const LocalProblem& problem);

/// The problem of some contacts (rising), with only the blocks that they touch, in their order.
ContactProblem select(const ContactProblem& problem, const std::vector<int>& contacts);
/// The local problem of some contacts (rising). The others are taken out, as if they had no impulses.
LocalProblem select(const LocalProblem& problem, const std::vector<int>& contacts);

}  // namespace nilas::contact
