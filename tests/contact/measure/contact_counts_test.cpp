/// Tests of the counts of contact states, with problems of known solution.
#include "contact/measure/contact_counts.h"

#include <gtest/gtest.h>

#include "contact/registry.h"
#include "tests/support/problems/cone_problems.h"

namespace contact_counts_test {

using namespace nilas;
using namespace nilas::contact;

ContactCounts counts_of(const ContactProblem& problem) {
  const auto solution = find_solver("newton").make({.tolerance = 1e-10})->solve(problem, {});
  const ContactCounts global = count_contacts(problem, solution.r, solution.u);
  const LocalProblem local = reduce(problem);
  const ContactCounts again = count_contacts(local, solution.r, contact_velocities(local, solution.r));
  EXPECT_EQ(global.open, again.open);
  EXPECT_EQ(global.sticking, again.sticking);
  EXPECT_EQ(global.sliding, again.sliding);
  return global;
}

TEST(ContactCounts, AParticleLeavesSticksOrSlides) {
  EXPECT_EQ(counts_of(test::particle(Law::coulomb, 2, 0.5, Vec3(1, 3, 0))).open, 1);
  EXPECT_EQ(counts_of(test::particle(Law::coulomb, 2, 0.5, Vec3(-1, 0.1, 0))).sticking, 1);
  EXPECT_EQ(counts_of(test::particle(Law::coulomb, 2, 0.5, Vec3(-1, 3, 0))).sliding, 1);
}

TEST(ContactCounts, AStackAtRestSticksAllOver) { EXPECT_EQ(counts_of(test::box_stack({1, 1, 1}, 0.5)).sticking, 12); }

}  // namespace contact_counts_test
