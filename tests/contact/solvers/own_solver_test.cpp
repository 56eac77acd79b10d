/// The solver of the page that shows how to add one: its answers, its limit of convergence and its statuses.
#include <gtest/gtest.h>

#include "contact/measure/measure.h"
#include "contact/solvers/nsgs.h"
#include "core/base/error.h"
#include "tests/contact/solvers/jacobi_example.h"
#include "tests/support/problems/cone_problems.h"

namespace nilas::solvers {
namespace own_solver_test {

constexpr double k_gravity = 9.81, k_step = 0.01;
constexpr double k_friction = 0.3, k_mass = 2;
const contact::SolverSettings k_exact{.tolerance = 1e-10, .max_iterations = 100000};

/// A cube that slides along x on the ground at 1 m/s and falls for one step. It has four contacts.
contact::ContactProblem sliding_cube(Law law) {
  contact::ContactProblem problem = test::box_stack({k_mass}, k_friction, k_step, k_gravity);
  problem.law = law;
  problem.f[0] = k_mass * 1.0;
  return problem;
}

/// The velocity is unique, though the impulses of four contacts on one face are not.
TEST(OwnSolver, AgreesWithGaussSeidelInBothForms) {
  for (const Law law : {Law::coulomb, Law::ccp, Law::frictionless}) {
    const contact::ContactProblem problem = sliding_cube(law);
    const VecX expected = NsgsSolver({.shared = k_exact}).solve(problem, {}).v;
    const JacobiSolver solver({.shared = k_exact});
    const contact::ContactSolution whole = solver.solve(problem, {}),
                                   reduced = solver.solve(contact::reduce(problem), {});
    EXPECT_EQ(whole.status, contact::SolveStatus::converged) << contact::to_string(law);
    EXPECT_EQ(reduced.status, contact::SolveStatus::converged) << contact::to_string(law);
    EXPECT_LE(contact::measure(problem, whole.r).law_map_m_s, k_exact.tolerance) << contact::to_string(law);
    EXPECT_LT((whole.v - expected).cwiseAbs().maxCoeff(), 1e-8) << contact::to_string(law);
    EXPECT_LT((contact::velocities(problem, reduced.r) - expected).cwiseAbs().maxCoeff(), 1e-8)
        << contact::to_string(law);
  }
}

/// Friction brakes the cube by mu g h = 0.3 * 9.81 * 0.01 m/s; it does not tip, since mu is below 1.
TEST(OwnSolver, BrakesASlidingCubeAsCoulombSays) {
  const contact::ContactSolution solution = JacobiSolver({.shared = k_exact}).solve(sliding_cube(Law::coulomb), {});
  EXPECT_NEAR(solution.v[0], 1 - k_friction * k_gravity * k_step, 1e-8);
  EXPECT_NEAR(solution.v.tail<5>().cwiseAbs().maxCoeff(), 0, 1e-8);
}

/// Of a single particle D^-1 W is the unit matrix. An error of the impulse is then multiplied by 1 - omega.
TEST(OwnSolver, ConvergesWhileAStepIsBelowTwoOverTheLargestEigenvalue) {
  const contact::ContactProblem problem = test::particle(Law::frictionless, k_mass, 0, {-1, 0, 0});
  const contact::ContactSolution below = JacobiSolver({.shared = k_exact, .omega = 1.9}).solve(problem, {});
  EXPECT_EQ(below.status, contact::SolveStatus::converged);
  EXPECT_NEAR(below.r[0], k_mass * 1.0, 1e-9);
  const contact::ContactSolution above = JacobiSolver({.shared = k_exact, .omega = 2.1}).solve(problem, {});
  EXPECT_EQ(above.status, contact::SolveStatus::stalled);
}

TEST(OwnSolver, SaysHonestlyThatItsIterationsRanOut) {
  const contact::ContactProblem problem = sliding_cube(Law::coulomb);
  for (const int most : {1, 10}) {
    const contact::SolverSettings shared{.tolerance = 1e-10, .max_iterations = most};
    const contact::ContactSolution solution = JacobiSolver({.shared = shared}).solve(problem, {});
    EXPECT_EQ(solution.status, contact::SolveStatus::iteration_limit) << most;
    EXPECT_EQ(solution.iterations, most);
    EXPECT_GT(contact::measure(problem, solution.r).law_map_m_s, shared.tolerance) << most;
  }
}

/// A contact that could stop the particle by 2 N s may carry 1.5 N s only.
TEST(OwnSolver, KeepsToAForceLimit) {
  contact::ContactProblem problem = test::particle(Law::coulomb, k_mass, k_friction, {-1, 0, 0});
  problem.force_limit[0] = 1.5;
  const contact::ContactSolution solution = JacobiSolver({.shared = k_exact}).solve(problem, {});
  EXPECT_EQ(solution.status, contact::SolveStatus::converged);
  EXPECT_NEAR(solution.r[0], 1.5, 1e-9);
}

TEST(OwnSolver, RefusesWhatItDoesNotKnow) {
  const JacobiSolver solver({.shared = k_exact});
  for (const Law law : {Law::pyramid, Law::pyramid_k}) EXPECT_THROW(solver.solve(sliding_cube(law), {}), InputError);
}

}  // namespace own_solver_test
}  // namespace nilas::solvers
