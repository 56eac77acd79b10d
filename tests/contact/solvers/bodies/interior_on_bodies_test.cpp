#include "contact/solvers/bodies/interior_on_bodies.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/measure/measure.h"
#include "contact/problem/row_of.h"
#include "contact/solvers/body_ladder.h"
#include "tests/contact/fclib/recorded_problems.h"
#include "tests/contact/solvers/bodies/island_with_vessel.h"

namespace nilas::solvers {
namespace interior_on_bodies_test {

InteriorOnBodies::Outcome run(const contact::ContactProblem& problem, double tolerance,
                              const InteriorSettings& settings) {
  const contact::PreparedProblem prepared(problem);
  const BodyIsland bodies(prepared);
  const auto plan = plan_nodes(bodies);
  InteriorOnBodies interior(prepared, bodies, plan.value());
  return interior.run(VecX::Zero(3 * problem.num_contacts()), tolerance, Budget({}), settings);
}

/// Where rounding ends the method, as a share of the speeds.
constexpr double k_rounding_share = 1e-6;

double tolerance_for(const contact::ContactProblem& problem) {
  return k_rounding_share * contact::measure(problem, VecX::Zero(3 * problem.num_contacts())).law_map_m_s;
}

/// Gives every third contact a limit, some of them compliance and some no friction.
void make_yielding(contact::ContactProblem& problem) {
  for (std::size_t c = 0; c < problem.pairs.size(); ++c) {
    if (c % 3 == 0) problem.force_limit[c] = c % 2 ? 0.3 : 1e-6;
    if (c % 4 == 1) problem.compliance[c] = 0.2;
    if (c % 5 == 0) problem.mu[c] = problem.mu_static[c] = 0;
  }
}

/// A convex law has no shift, so that nothing keeps the method from its rate, force limits and compliance included.
TEST(InteriorOnBodies, SolvesConvexLawsInFewIterations) {
  for (const Law law : {Law::ccp, Law::frictionless})
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      contact::ContactProblem problem = test::largest_island(test::heap_with_vessel(seed, 9, 20, seed % 2 ? 0.3 : 1.4));
      problem.law = law;
      make_yielding(problem);
      const double tolerance = tolerance_for(problem);
      const auto found = run(problem, tolerance, {});
      EXPECT_LE(found.law_map_m_s, tolerance) << static_cast<int>(law) << " " << seed;
      EXPECT_LE(found.iterations, 30) << static_cast<int>(law) << " " << seed;
      EXPECT_NEAR(contact::measure(problem, found.r).law_map_m_s, found.law_map_m_s, 1e-12);
    }
}

/// Impulses of a limit differ by twelve decades from those of the others: what the limits leave must keep its digits.
TEST(InteriorOnBodies, KeepsTheDigitsOfLimits) {
  contact::ContactProblem problem = test::largest_island(test::box_stack(test::growing_masses(6, 1e4), 0.4));
  problem.law = Law::ccp;
  for (std::size_t c = 0; c < problem.pairs.size(); ++c) problem.force_limit[c] = c % 4 == 3 ? 1e-8 : 1e4;
  EXPECT_LE(run(problem, 1e-6, {}).law_map_m_s, 1e-6);
}

TEST(InteriorOnBodies, AllShiftsLeadToCoulombsLaw) {
  for (const bool yields : {false, true})
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      contact::ContactProblem problem = test::largest_island(test::heap_with_vessel(seed, 9, 20, 0.15));
      if (yields) make_yielding(problem);
      const double tolerance = tolerance_for(problem);
      const auto expect_solved = [&](double asked, const InteriorSettings& settings) {
        EXPECT_LE(contact::measure(problem, run(problem, asked, settings).r).law_map_m_s, 1.001 * asked)
            << seed << (yields ? " with limits" : "");
      };
      expect_solved(tolerance, {});
      expect_solved(tolerance, {Shift::differentiated, 0.7, 1, 20});
      // each round is solved to a share of the tolerance, which must stay above rounding
      expect_solved(100 * tolerance, {Shift::held, 0, 1, 12});
    }
}

/// Units carry no meaning: masses a million times as large leave the velocities and the number of iterations alone.
TEST(InteriorOnBodies, IterationsDoNotDependOnTheScaleOfMasses) {
  contact::ContactProblem problem = test::largest_island(test::heap_with_vessel(5, 9, 20, 0.15));
  const auto light = run(problem, 1e-6, {});
  const double scale = std::ldexp(1.0, 20);
  for (double& m : problem.mass_data) m *= scale;
  problem.f *= scale;
  const auto heavy = run(problem, 1e-6, {});
  EXPECT_EQ(heavy.iterations, light.iterations);
  EXPECT_LT((heavy.r - scale * light.r).norm(), 1e-9 * heavy.r.norm());
}

std::optional<BodyOutcome> climb(const contact::ContactProblem& problem, const contact::SolverSettings& settings) {
  return solve_on_bodies(contact::PreparedProblem(problem), {}, settings, Budget(settings));
}

TEST(BodyLadder, SolvesHeapsWithMuchFrictionToRounding) {
  for (const double mu : {0.15, 0.5, 1.4})
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      contact::ContactProblem problem = test::largest_island(test::heap_with_vessel(seed, 9, 20, mu));
      if (seed % 2 == 1) make_yielding(problem);
      const auto found = climb(problem, {.tolerance = 1e-10, .keep_history = true});
      ASSERT_TRUE(found.has_value());
      EXPECT_TRUE(found->has_converged) << mu << " " << seed << ": " << found->law_map_m_s;
      EXPECT_LE(contact::measure(problem, found->r).law_map_m_s, 1.001e-10) << mu << " " << seed;
      EXPECT_GE(static_cast<int>(found->history.size()), found->interior);
    }
}

/// Convex laws have one way only, from the guess, and nothing after it: it must suffice with masses that differ by six
/// decades, limits and compliance, from nothing and from guesses that are far too large or of the wrong sign.
TEST(BodyLadder, SolvesHardConvexIslands) {
  for (const Law law : {Law::ccp, Law::frictionless})
    for (const bool yields : {false, true})
      for (contact::ContactProblem problem :
           {test::box_stack(test::growing_masses(8, 1e6), 0.8), test::raft(12, 0.8, 0.9, 3),
            test::largest_island(test::heap_with_vessel(4, 30, 90, 1.4))}) {
        problem = test::largest_island(problem);
        problem.law = law;
        if (yields) make_yielding(problem);
        const contact::PreparedProblem prepared(problem);
        const contact::SolverSettings settings{.tolerance = 1e-8};
        const VecX one = VecX::Constant(3 * problem.num_contacts(), 1);
        for (const double size : {0.0, 1e6, -1.0}) {
          const auto found = solve_on_bodies(prepared, size * one, settings, Budget(settings));
          ASSERT_TRUE(found.has_value());
          EXPECT_TRUE(found->has_converged)
              << static_cast<int>(law) << (yields ? " with limits, " : ", ") << problem.num_contacts()
              << " contacts, guess " << size << ": " << found->law_map_m_s << " m/s after " << found->interior
              << " and " << found->newton;
          EXPECT_LE(contact::measure(problem, found->r).law_map_m_s, 1.001e-8);
        }
      }
}

/// A step that was solved to 1e-4 m/s and is solved again to 1e-8 m/s: its impulses save a quarter of the iterations.
TEST(BodyLadder, SolvesASolvedIslandAgainInFewerIterations) {
  int from_nothing = 0, from_solution = 0;
  for (const int seed : {1, 2, 3, 4, 5, 6}) {
    const contact::ContactProblem raft = test::raft(12, 0.3, 1, seed);
    const contact::PreparedProblem prepared(raft);
    const contact::SolverSettings loose{.tolerance = 1e-4}, strict{.tolerance = 1e-8};
    const auto solved = solve_on_bodies(prepared, {}, loose, Budget(loose)).value();
    ASSERT_TRUE(solved.has_converged);
    const auto cold = solve_on_bodies(prepared, {}, strict, Budget(strict)).value();
    const auto warm = solve_on_bodies(prepared, solved.r, strict, Budget(strict)).value();
    EXPECT_TRUE(warm.has_converged);
    EXPECT_LE(contact::measure(raft, warm.r).law_map_m_s, 1.001e-8);
    from_nothing += cold.interior + cold.newton;
    from_solution += warm.interior + warm.newton;
  }
  EXPECT_LT(4 * from_solution, 3 * from_nothing) << from_solution << " and " << from_nothing;
}

TEST(BodyLadder, KeepsToItsBudget) {
  const contact::ContactProblem problem = test::largest_island(test::heap_with_vessel(2, 9, 20, 0.5));
  contact::SolverSettings settings{.tolerance = 1e-14};
  settings.max_iterations = 7;
  const auto found = climb(problem, settings);
  ASSERT_TRUE(found.has_value());
  EXPECT_LE(found->interior + found->newton, 7);
  EXPECT_LT(found->law_map_m_s, contact::measure(problem, VecX::Zero(3 * problem.num_contacts())).law_map_m_s);
}

/// A step of level ice whose contacts all have limits. From a start near the ends of the cones it took 150 iterations
/// to 1e-4 m/s, and 826 to 1.1e-5 m/s.
TEST(BodyLadder, SolvesLimitedContactsFromFarInside) {
  const contact::FclibProblem file = contact::read_fclib(test::own_problem("loose/level-ice-jam"));
  const auto problem = test::largest_island(std::get<contact::ContactProblem>(file.problem));
  for (const double tolerance : {1e-4, 1.1e-5}) {
    const auto found = climb(problem, {.tolerance = tolerance, .max_iterations = 1000});
    ASSERT_TRUE(found.has_value());
    EXPECT_TRUE(found->has_converged) << found->law_map_m_s;
    EXPECT_LE(contact::measure(problem, found->r).law_map_m_s, 1.001 * tolerance);
    EXPECT_LE(found->interior + found->sweeps + found->newton, 90);
  }
}

/// Rafts with much friction, which the ways with a slope leave at a few contacts.
TEST(BodyLadder, SolvesByTurnsWhatTheWaysLeave) {
  int newton = 0;
  for (const std::uint64_t seed : {1, 3, 8}) {
    const contact::ContactProblem raft = test::raft(10, 0.8, 1, seed);
    const contact::SolverSettings loose{.tolerance = 1e-3};
    const auto found = solve_on_bodies(contact::PreparedProblem(raft), {}, loose, Budget(loose)).value();
    EXPECT_TRUE(found.has_converged) << found.law_map_m_s;
    EXPECT_LE(contact::measure(raft, found.r).law_map_m_s, 1.001e-3);
    EXPECT_LE(found.interior + found.sweeps + found.newton, 300);
    newton += found.newton;
  }
  EXPECT_GT(newton, 0);
}

TEST(BodyLadder, LeavesWhatItDoesNotKnowToOthers) {
  const contact::ContactProblem good = test::largest_island(test::heap_with_vessel(2, 9, 20, 0.5));
  EXPECT_TRUE(fits_bodies(contact::PreparedProblem(good)));
  const auto expect_refused = [&](const auto& spoil) {
    contact::ContactProblem problem = good;
    spoil(problem);
    EXPECT_FALSE(fits_bodies(contact::PreparedProblem(problem)));
    EXPECT_FALSE(climb(problem, {}).has_value());
  };
  const double nan = std::nan("");
  expect_refused([](auto& problem) { problem.law = Law::pyramid; });
  expect_refused([&](auto& problem) { problem.w[2] = nan; });
  expect_refused([&](auto& problem) { problem.force_limit[1] = nan; });
  expect_refused([](auto& problem) { problem.mass_data[0] = -1; });
  expect_refused([](auto& problem) { problem.tangential_compliance[0] = 0.1; });
  expect_refused([](auto& problem) { problem.add_contact(-1, MatX(3, 0), -1, MatX(3, 0), 9999); });
  expect_refused([](auto& problem) {
    problem.add_moment(0, 0.1 * MatX(problem.jacobian_a(0)), 0.1 * MatX(problem.jacobian_b(0)), 0.1, 9999);
  });
  expect_refused([](auto& problem) { problem = {}; });
}

/// What one iteration on the bodies of a raft of 80 x 80 floes finds, from unit impulses at the first contacts.
std::optional<BodyOutcome> after_one_iteration(const contact::ContactProblem& raft, int closing) {
  const contact::SolverSettings shared{.tolerance = 1e-12, .max_iterations = 1};
  VecX guess = VecX::Zero(contact::row_of(raft.num_contacts()));
  for (int c = 0; c < closing; ++c) guess[contact::row_of(c)] = 1;
  return solve_on_bodies(contact::PreparedProblem(raft), guess, shared, Budget(shared));
}

/// Where all contacts of a large raft carry something, W would have many rows for each body. Where a few do, it leaves
/// out all others.
TEST(BodyLadder, LeavesLargeIslandsToWWhereFewContactsClose) {
  const contact::ContactProblem raft = test::raft(80, 0.3, 1, 1);
  ASSERT_GT(raft.num_contacts(), 20000);
  EXPECT_TRUE(after_one_iteration(raft, raft.num_contacts()));
  contact::ContactProblem open = raft;
  for (int c = 0; c < open.num_contacts(); ++c) open.w[contact::row_of(c)] = 1e6;
  EXPECT_FALSE(after_one_iteration(open, 4));
  EXPECT_TRUE(after_one_iteration(open, open.num_contacts()));
}

}  // namespace interior_on_bodies_test
}  // namespace nilas::solvers
