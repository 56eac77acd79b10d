#include "contact/problem/prepared_problem.h"

#include <gtest/gtest.h>

#include "contact/measure/measure.h"
#include "contact/problem/islands.h"
#include "core/base/error.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::contact {
namespace prepared_problem_test {

TEST(PreparedProblem, HoldsWhatFollowsFromTheProblem) {
  const ContactProblem problem = test::random_heap(2, 6, 9, 0.4);
  const PreparedProblem prepared(problem);
  EXPECT_EQ(prepared.islands(), find_islands(problem));
  EXPECT_EQ(prepared.masses().first_bad_block(), -1);
  const auto blocks = delassus_diagonal(problem);
  ASSERT_EQ(prepared.inverse_mass_scales().size(), blocks.size());
  for (std::size_t c = 0; c < blocks.size(); ++c)
    EXPECT_NEAR(prepared.inverse_mass_scales()[c], blocks[c].trace() / 3, 1e-14 * blocks[c].trace());
}

TEST(PreparedProblem, IsMeasuredToTheSameBits) {
  const ContactProblem problem = test::random_heap(3, 6, 9, 0.4);
  const PreparedProblem prepared(problem);
  const VecX r = VecX::Constant(3 * problem.num_contacts(), 0.5);
  EXPECT_EQ(velocities(prepared, r), velocities(problem, r));
  const Residuals once = measure(prepared, r), again = measure(problem, r);
  for (const auto& column : residual_columns()) EXPECT_EQ(once.*column.member, again.*column.member) << column.name;
}

TEST(PreparedProblem, RefusesListsOfDifferentLengths) {
  ContactProblem problem = test::random_heap(3, 6, 9, 0.4);
  problem.mu.pop_back();
  EXPECT_THROW(PreparedProblem{problem}, ContractError);
}

}  // namespace prepared_problem_test
}  // namespace nilas::contact
