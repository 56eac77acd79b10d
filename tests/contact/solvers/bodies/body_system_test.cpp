#include "contact/solvers/bodies/body_system.h"

#include <gtest/gtest.h>

#include "contact/measure/measure.h"
#include "contact/solvers/newton/delassus_system.h"
#include "tests/contact/solvers/bodies/island_with_vessel.h"

namespace nilas::solvers {
namespace body_system_test {

/// Newton's step on the bodies is the step between the contacts, whatever the law, limits and compliance.
TEST(BodySystem, TakesTheStepOfTheDelassusSystem) {
  for (const Law law : {Law::coulomb, Law::ccp, Law::pyramid, Law::frictionless})
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      contact::ContactProblem problem = test::largest_island(test::heap_with_vessel(seed, 7, 15, 0.4));
      problem.law = law;
      for (std::size_t c = 0; c < problem.pairs.size(); ++c) {
        if (c % 3 == 0) problem.force_limit[c] = 0.5;
        if (c % 4 == 1) problem.compliance[c] = 0.2;
        if (c % 4 < 2) problem.tangential_compliance[c] = 0.1;
      }
      const contact::PreparedProblem prepared(problem);
      const BodyIsland bodies(prepared);
      const NodePlan plan = plan_nodes(bodies).value();
      BodySystem on_bodies(prepared, bodies, plan);
      const contact::LocalProblem local = contact::reduce(problem);
      DelassusSystem between(local);

      RandomStream random(seed, "impulses");
      VecX r(3 * problem.num_contacts());
      for (double& x : r) x = random.normal();
      r = on_bodies.scaled(r);
      const VecX u = on_bodies.velocities(r);
      EXPECT_LT((u - between.velocities(r)).norm(), 1e-11 * u.norm());
      EXPECT_NEAR(on_bodies.linearise(r, u), between.linearise(r, u), 1e-11);
      const double judged = contact::measure(problem, on_bodies.impulses(r)).law_map_m_s;
      EXPECT_NEAR(on_bodies.residual(r), judged, 1e-11 * judged);
      EXPECT_NEAR(between.residual(r), judged, 1e-11 * judged);
      VecX dr, expected;
      ASSERT_TRUE(on_bodies.step(1e-2, r, dr));
      ASSERT_TRUE(between.step(1e-2, r, expected));
      EXPECT_LT((dr - expected).norm(), 1e-8 * expected.norm()) << static_cast<int>(law) << " " << seed;
    }
}

}  // namespace body_system_test
}  // namespace nilas::solvers
