#pragma once
/// Whether the Delassus operator W of an island is small enough to be formed and factorised.
#include <string>
#include <vector>

#include "contact/problem/problem.h"

namespace nilas::contact {

/// W has a block for every pair of contacts of one body: up to 5e6 blocks (360 MB) are formed, and beyond 20000
/// contacts only where its factors fill at most 8e6 blocks. In fields of floes, at 1e4 and 1e5 contacts, a
/// factorisation of W beats all methods that go without by an order of magnitude; a jam of 2000 contacts on one hull,
/// or a great heap, are left to these.
bool is_reducible(const ContactProblem& problem, const std::vector<int>& contacts);

/// Returns a message about an island that is not reducible, with its number of contacts and the solvers that take it.
std::string not_reducible_message(const std::vector<int>& contacts);

}  // namespace nilas::contact
