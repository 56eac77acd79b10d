#include "contact/solvers/bodies/interior_on_bodies.h"

#include <gtest/gtest.h>

#include "contact/measure/measure.h"
#include "contact/solvers/bodies/body_ladder.h"
#include "tests/contact/solvers/bodies/island_with_vessel.h"

namespace nilas::solvers {
namespace interior_on_bodies_test {

InteriorOnBodies::Outcome run(const contact::ContactProblem& problem, double tolerance, Shift shift) {
  const contact::PreparedProblem prepared(problem);
  const BodyIsland bodies(prepared);
  const NodePlan plan = plan_nodes(bodies);
  InteriorOnBodies interior(prepared, bodies, plan);
  return interior.run(VecX::Zero(3 * problem.num_contacts()), tolerance, Budget({}), shift);
}

/// Where rounding ends the method, as a share of the speeds.
constexpr double k_rounding_share = 1e-6;

double tolerance_for(const contact::ContactProblem& problem) {
  return k_rounding_share * contact::measure(problem, VecX::Zero(3 * problem.num_contacts())).law_map_m_s;
}

/// A convex law has no shift, so that nothing keeps the method from its rate, force limits and compliance included.
TEST(InteriorOnBodies, SolvesConvexLawsInFewIterations) {
  for (const Law law : {Law::ccp, Law::frictionless})
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      contact::ContactProblem problem = test::largest_island(test::heap_with_vessel(seed, 9, 20, seed % 2 ? 0.3 : 1.4));
      problem.law = law;
      for (std::size_t c = 0; c < problem.pairs.size(); ++c) {
        if (c % 3 == 0) problem.force_limit[c] = c % 2 ? 0.3 : 1e-6;
        if (c % 4 == 1) problem.compliance[c] = 0.2;
        if (c % 5 == 0) problem.mu[c] = 0;
      }
      const double tolerance = tolerance_for(problem);
      const auto found = run(problem, tolerance, Shift::lagged);
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
  EXPECT_LE(run(problem, 1e-6, Shift::lagged).law_map_m_s, 1e-6);
}

TEST(InteriorOnBodies, BothShiftsLeadToCoulombsLaw) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const contact::ContactProblem problem = test::largest_island(test::heap_with_vessel(seed, 9, 20, 0.15));
    const double tolerance = tolerance_for(problem);
    for (const Shift shift : {Shift::lagged, Shift::differentiated})
      EXPECT_LE(contact::measure(problem, run(problem, tolerance, shift).r).natural_map_m_s, 1.001 * tolerance) << seed;
  }
}

/// Units carry no meaning: masses a million times as large leave the velocities and the number of iterations alone.
TEST(InteriorOnBodies, IterationsDoNotDependOnTheScaleOfMasses) {
  contact::ContactProblem problem = test::largest_island(test::heap_with_vessel(5, 9, 20, 0.15));
  const auto light = run(problem, 1e-6, Shift::lagged);
  const double scale = std::ldexp(1.0, 20);
  for (double& m : problem.mass_data) m *= scale;
  problem.f *= scale;
  const auto heavy = run(problem, 1e-6, Shift::lagged);
  EXPECT_EQ(heavy.iterations, light.iterations);
  EXPECT_LT((heavy.r - scale * light.r).norm(), 1e-9 * heavy.r.norm());
}

TEST(BodyLadder, SolvesHeapsWithMuchFrictionToRounding) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const contact::ContactProblem problem = test::largest_island(test::heap_with_vessel(seed, 9, 20, 0.5));
    const contact::PreparedProblem prepared(problem);
    ASSERT_TRUE(fits_bodies(prepared));
    const contact::SolverSettings settings{.tolerance = 1e-10, .keep_history = true};
    const BodyOutcome found = solve_on_bodies(prepared, {}, settings, Budget(settings));
    EXPECT_TRUE(found.has_converged) << seed << ": " << found.law_map_m_s;
    EXPECT_EQ(found.history.empty(), false);
  }
}

TEST(BodyLadder, KeepsToItsBudget) {
  const contact::ContactProblem problem = test::largest_island(test::heap_with_vessel(2, 9, 20, 0.5));
  const contact::PreparedProblem prepared(problem);
  contact::SolverSettings settings{.tolerance = 1e-14};
  settings.max_iterations = 7;
  const BodyOutcome found = solve_on_bodies(prepared, {}, settings, Budget(settings));
  EXPECT_LE(found.interior + found.newton, 7);
  EXPECT_LT(found.law_map_m_s, contact::measure(problem, VecX::Zero(3 * problem.num_contacts())).law_map_m_s);
}

TEST(BodyLadder, LeavesWhatItDoesNotKnowToOthers) {
  contact::ContactProblem problem = test::largest_island(test::heap_with_vessel(2, 9, 20, 0.5));
  problem.law = Law::pyramid;
  EXPECT_FALSE(fits_bodies(contact::PreparedProblem(problem)));
}

}  // namespace interior_on_bodies_test
}  // namespace nilas::solvers
