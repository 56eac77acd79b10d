#pragma once
/// Solves large islands most of whose contacts stay open by those that close.
///
/// A contact without impulse whose law holds can be left out: the answer stays the same, and an island falls apart
/// where only such contacts join it. Which they are is guessed from impulses near the solution and seen in the answer,
/// where their law must hold again:
///   A = {c : r_c != 0 or law_map_c > 0},   solve A alone,   add to A those with law_map_c > 0,   until all is solved
/// So the law holds for all contacts at the end. A field of 1e5 contacts before a hull becomes 4400 islands of up to
/// 300 contacts and takes three or four rounds. In a jam most contacts close, and nothing is gained.
#include <functional>
#include <vector>

#include "contact/problem/prepared_problem.h"
#include "contact/problem/solution.h"

namespace nilas::solvers {

/// Solves a part of an island from a guess. `done`: the iterations that the island took so far.
using PartSolve =
    std::function<contact::ContactSolution(const contact::PreparedProblem& part, const VecX& guess, int done)>;

/// What the rounds leave and what they took. Each island is counted alone, so that many islands do not use up what one
/// of them may take.
struct ClosingOutcome {
  std::vector<std::vector<int>> unsolved;  ///< islands of the whole with a contact above the tolerance or not a number
  int iterations = 0;                      ///< of the island that took most
  std::vector<double> history;             ///< of all islands together, as merge_history puts it
};

/// Replaces impulses by those that `solve` finds for the closing contacts, where these fall apart: of an unsolved
/// island of 200 contacts or more, at most a tenth may hang together. Ends at the first part that is not solved.
/// The tolerance is of law_map [m/s].
ClosingOutcome solve_closing(const contact::PreparedProblem& whole, double tolerance, const PartSolve& solve, VecX& r);

/// Marks the contacts that have an impulse or whose law does not hold with these impulses.
std::vector<char> closing_contacts(const contact::PreparedProblem& problem, const VecX& r);

/// The impulses of some contacts.
VecX impulses_of(const VecX& r, const std::vector<int>& contacts);

}  // namespace nilas::solvers
