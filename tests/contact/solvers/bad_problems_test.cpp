/// Statuses of every solver for problems that have no solution, or that it cannot take: one table for all.
#include "tests/support/problems/bad_problems.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <map>

#include "contact/registry.h"
#include "contact/solvers/admm.h"
#include "contact/solvers/continuation.h"
#include "contact/solvers/with_retry.h"
#include "tests/support/problems/problem_factory.h"
#include "tests/support/test_name.h"

namespace nilas::solvers {
namespace bad_problems_test {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_infinite = std::numeric_limits<double>::infinity();
constexpr double k_tolerance = 1e-9;
const contact::SolverSettings k_settings{.tolerance = k_tolerance, .max_iterations = 2000};

/// The same pair twice: four contacts on the same two rows of W.
contact::LocalProblem all_twice() {
  contact::ContactProblem heap = test::random_heap(1, 3, 3, 0.3);
  const int nc = heap.num_contacts();
  for (int c = 0; c < nc; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const MatX a = heap.jacobian_a(c), b = heap.jacobian_b(c);
    const int twin = heap.add_contact(heap.pairs[i].a, a, heap.pairs[i].b, b, 1000 + heap.key[i]);
    heap.mu.back() = heap.mu[i];
    heap.mu_static.back() = heap.mu_static[i];
    heap.w.segment<3>(3 * twin) = heap.w.segment<3>(3 * c);
  }
  return contact::reduce(heap);
}

contact::LocalProblem with(contact::LocalProblem problem, const std::function<void(contact::LocalProblem&)>& change) {
  change(problem);
  return problem;
}

/// Boxes of very different masses with the heaviest on top.
contact::LocalProblem steep_stack() { return contact::reduce(test::box_stack({1e-3, 1, 1e3}, 0.5)); }

struct BadProblem {
  std::string name;
  contact::LocalProblem problem;
  VecX guess;
  contact::SolveStatus expected;                         ///< Status of every other solver.
  std::map<std::string, contact::SolveStatus> except{};  ///< Status of the solvers that differ, by name.
};

std::vector<BadProblem> bad_problems() {
  using enum contact::SolveStatus;
  const auto shared = test::coupled_pair(0);
  return {
      // A solution exists, but W has the eigenvalue -2.
      {"indefinite", test::coupled_pair(3), {}, converged, {{"admm", numerical_error}}},
      // Impulses amplify each other without end: there is no solution.
      {"indefinite without answer",
       test::coupled_pair(-3),
       {},
       numerical_error,
       {{"continuation", stalled},
        {"enumerate", stalled},
        {"newton", iteration_limit},
        {"newton-order-free", iteration_limit},
        {"auto", iteration_limit}}},
      // One contact can open only as far as the other closes, and both close: there is no solution.
      {"singular without answer",
       test::coupled_pair(-1),
       {},
       stalled,
       {{"eg", numerical_error},
        {"admm", numerical_error},
        {"with retry", numerical_error},
        {"eg-order-free", iteration_limit},
        {"apgd", iteration_limit},
        {"newton", iteration_limit},
        {"newton-order-free", iteration_limit},
        {"auto", iteration_limit}}},
      {"singular", all_twice(), {}, converged, {}},
      {"nothing to solve", contact::LocalProblem{}, {}, converged, {}},
      {"velocity not a number", with(shared, [](auto& p) { p.q[4] = k_nan; }), {}, numerical_error, {}},
      {"infinite friction", with(shared, [](auto& p) { p.mu[1] = k_infinite; }), {}, numerical_error, {}},
      {"infinite inverse mass", with(shared, [](auto& p) { p.block[3](1, 1) = k_infinite; }), {}, numerical_error, {}},
      {"negative mass", with(shared, [](auto& p) { p.block[0] *= -1; }), {}, numerical_error, {}},
      {"limit not a number", with(shared, [](auto& p) { p.force_limit[0] = k_nan; }), {}, numerical_error, {}},
      // Continuation takes no guess, and a second solver starts without one.
      {"guess not a number",
       shared,
       VecX::Constant(6, k_nan),
       numerical_error,
       {{"continuation", converged}, {"with retry", converged}}},
      {"nothing yields", with(shared, [](auto& p) { p.block[0].setZero(); }), {}, numerical_error, {}},
      {"steep stack",
       steep_stack(),
       {},
       converged,
       {{"pgs", stalled},
        {"nsgs", stalled},
        {"eg", iteration_limit},
        {"eg-order-free", iteration_limit},
        {"apgd", iteration_limit},
        {"enumerate", numerical_error}}},
      // Products with the guess overflow. Solvers that measure it first start from zero.
      {"numbers near the largest",
       test::coupled_pair(0, 1e200),
       VecX::Constant(6, 1e200),
       converged,
       {{"eg", numerical_error}, {"eg-order-free", numerical_error}, {"apgd", numerical_error}}},
  };
}

/// Solves with a solver by name, also with friction continuation and with a solver followed by a second one.
contact::ContactSolution solve(const std::string& name, const contact::LocalProblem& problem, const VecX& guess) {
  if (name == "continuation") return continue_in_friction(problem, {.shared = k_settings}, Budget(k_settings));
  if (name == "with retry")
    return WithRetry(contact::find_solver("admm").make(k_settings), contact::find_solver("nsgs").make(k_settings))
        .solve(problem, guess);
  return contact::find_solver(name).make(k_settings)->solve(problem, guess);
}

class BadProblems : public testing::TestWithParam<std::string> {};

TEST_P(BadProblems, AreCalledWhatTheyAre) {
  for (const BadProblem& bad : bad_problems()) {
    SCOPED_TRACE(bad.name);
    const contact::ContactSolution found = solve(GetParam(), bad.problem, bad.guess);
    const auto other = bad.except.find(GetParam());
    EXPECT_STREQ(contact::to_string(found.status),
                 contact::to_string(other == bad.except.end() ? bad.expected : other->second))
        << found.iterations << " iterations, message '" << found.message << "'";
    EXPECT_EQ(found.r.size(), bad.problem.q.size());
    EXPECT_TRUE(found.r.allFinite()) << found.r.transpose();
    EXPECT_TRUE(found.status != contact::SolveStatus::numerical_error || !found.message.empty());
    EXPECT_TRUE(found.status != contact::SolveStatus::converged ||
                contact::measure(bad.problem, found.r).law_map_m_s <= k_tolerance);
  }
}

std::vector<std::string> all_solvers() {
  std::vector<std::string> names{"continuation", "with retry"};
  for (const auto& entry : contact::solver_registry()) names.push_back(entry.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, BadProblems, testing::ValuesIn(all_solvers()),
                         [](const auto& each) { return test::test_name(each.param); });

}  // namespace bad_problems_test
}  // namespace nilas::solvers
