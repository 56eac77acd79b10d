#include "contact/solvers/closing_contacts.h"

#include <gtest/gtest.h>

#include <numeric>

#include "contact/measure/measure.h"
#include "contact/problem/operators.h"
#include "contact/problem/row_of.h"
#include "contact/registry.h"
#include "contact/solvers/auto.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::solvers {
namespace closing_contacts_test {

constexpr double k_tolerance = 1e-9;

/// Rows of bodies of 1 kg without friction, each of which closes on the next where it approaches it faster than 1 m/s.
/// The first one moves.
contact::ContactProblem rows_of_bodies(const std::vector<int>& counts, double speed) {
  contact::ContactProblem problem;
  problem.h = 0.01;
  std::vector<test::TestBody> bodies;
  for (const int count : counts) {
    const int first = static_cast<int>(bodies.size());
    for (int k = 0; k < count; ++k) {
      test::TestBody body;
      body.p = Vec3(k, 0, 0);
      body.v = Vec3(k == 0 ? speed : 0, 0, 0);
      bodies.push_back(body);
      test::add_body(problem, body);
    }
    for (int k = first; k + 1 < first + count; ++k) {
      const Vec3 place(k - first + 0.5, 0, 0);
      const int c = test::add_contact(problem, bodies, k, k + 1, place, test::frame_of(Vec3::UnitX()), 0);
      problem.w[3 * c] = 1;
    }
  }
  return problem;
}

contact::ContactProblem row_of_bodies(int count, double speed) { return rows_of_bodies({count}, speed); }

/// The sizes of the parts that are solved, in turn.
std::vector<int> sizes_of_parts(const contact::ContactProblem& problem) {
  std::vector<int> sizes;
  const PartSolve solve = [&](const contact::PreparedProblem& part, const VecX& guess, int) {
    sizes.push_back(part.problem().num_contacts());
    return contact::find_solver("newton").make({.tolerance = k_tolerance})->solve(part, guess);
  };
  VecX r = VecX::Zero(contact::row_of(problem.num_contacts()));
  EXPECT_TRUE(solve_closing(contact::PreparedProblem(problem), k_tolerance, solve, r).unsolved.empty());
  return sizes;
}

/// m bodies that hang together move at v_m, v_m + 1, ... v_m + m - 1 and keep the momentum of the first: m v_m +
/// m (m - 1)/2 = 50 has its solution with 0 <= v_m <= 1 for m = 10, v_m = 0.5. So nine contacts close, which each round
/// finds one farther: two bodies of 25.5 and 24.5 m/s, three of 17.67, 16.67 and 15.67 m/s, and so on.
TEST(ClosingContacts, AreFoundOneAfterTheOther) {
  const contact::ContactProblem row = row_of_bodies(2000, 50);
  const contact::PreparedProblem whole(row);
  std::vector<int> sizes;
  const PartSolve solve = [&](const contact::PreparedProblem& part, const VecX& guess, int) {
    sizes.push_back(part.problem().num_contacts());
    return contact::find_solver("newton").make({.tolerance = k_tolerance})->solve(part, guess);
  };
  VecX r = VecX::Zero(contact::row_of(row.num_contacts()));
  EXPECT_TRUE(solve_closing(whole, k_tolerance, solve, r).unsolved.empty());
  std::vector<int> expected(9);
  std::iota(expected.begin(), expected.end(), 1);
  EXPECT_EQ(sizes, expected);
  const VecX v = contact::velocities(whole, r);
  for (int k = 0; k < 10; ++k) EXPECT_NEAR(v[row.block_offset[k]], 9.5 - k, 1e-8);
  for (int k = 10; k < 2000; ++k) EXPECT_EQ(v[row.block_offset[k]], 0);
}

/// An island's way does not depend on others beside it, larger or smaller.
TEST(ClosingContacts, OfEachIslandAreFoundAlone) {
  std::vector<int> twice = sizes_of_parts(row_of_bodies(2000, 50));
  EXPECT_EQ(sizes_of_parts(row_of_bodies(300, 50)), twice);
  twice.insert(twice.end(), twice.begin(), twice.end());
  EXPECT_EQ(sizes_of_parts(rows_of_bodies({2000, 300}, 50)), twice);
}

/// Where most contacts close they hang together, and the island is as hard without the others.
TEST(ClosingContacts, OfAJamAreLeftTogether) {
  const contact::ContactProblem raft = test::raft(24, 0.3, 1, 1);
  const contact::PreparedProblem whole(raft);
  const PartSolve solve = [](const contact::PreparedProblem& part, const VecX&, int) {
    ADD_FAILURE() << "a part of " << part.problem().num_contacts() << " contacts";
    return contact::ContactSolution();
  };
  VecX r = VecX::Zero(contact::row_of(raft.num_contacts()));
  EXPECT_EQ(solve_closing(whole, k_tolerance, solve, r).unsolved, whole.islands());
  EXPECT_TRUE(r.isZero(0));
}

TEST(ClosingContacts, EndAtAPartThatIsNotSolved) {
  const contact::ContactProblem row = row_of_bodies(2000, 50);
  const contact::PreparedProblem whole(row);
  int calls = 0;
  const PartSolve solve = [&](const contact::PreparedProblem& part, const VecX& guess, int) {
    ++calls;
    return contact::find_solver("newton").make({.tolerance = k_tolerance, .max_iterations = 0})->solve(part, guess);
  };
  VecX r = VecX::Zero(contact::row_of(row.num_contacts()));
  EXPECT_EQ(solve_closing(whole, k_tolerance, solve, r).unsolved.size(), 1u);
  EXPECT_EQ(calls, 1);
}

/// Three pairs of ten touch, too few to hang together across the raft. Newton on all contacts finds the same motion.
TEST(ClosingContacts, OfAFieldAreSolvedApart) {
  const contact::ContactProblem field = test::raft(32, 0.3, 0.3, 1);
  const auto with = [&](int threads) {
    return AutoSolver({.shared = {.tolerance = k_tolerance, .threads = threads}}).solve(field, VecX());
  };
  const contact::ContactSolution apart = with(1);
  EXPECT_EQ(apart.status, contact::SolveStatus::converged) << apart.message;
  EXPECT_NE(apart.message.find("islands"), std::string::npos) << apart.message;
  EXPECT_LE(contact::measure(field, apart.r).law_map_m_s, k_tolerance);
  const auto together = contact::find_solver("newton").make({.tolerance = k_tolerance})->solve(field, VecX());
  ASSERT_EQ(together.status, contact::SolveStatus::converged);
  EXPECT_LE((apart.v - together.v).cwiseAbs().maxCoeff(), 1e-6);
  const contact::ContactSolution shared = with(2);
  EXPECT_EQ(apart.r, shared.r);
}

/// Iterations are those of the island that takes most, so a field that is wider needs no more of them.
TEST(ClosingContacts, OfManyIslandsTakeNoMoreIterations) {
  const AutoSolver one({.shared = {.tolerance = k_tolerance}});
  const contact::ContactSolution alone = one.solve(row_of_bodies(300, 50), VecX());
  ASSERT_EQ(alone.status, contact::SolveStatus::converged) << alone.message;
  const AutoSolver limited({.shared = {.tolerance = k_tolerance, .max_iterations = 3 * alone.iterations}});
  const contact::ContactSolution wide = limited.solve(rows_of_bodies(std::vector<int>(12, 300), 50), VecX());
  EXPECT_EQ(wide.status, contact::SolveStatus::converged) << wide.message;
  EXPECT_EQ(wide.iterations, alone.iterations) << wide.message;
}

}  // namespace closing_contacts_test
}  // namespace nilas::solvers
