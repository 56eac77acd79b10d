/// Visits of four contacts at once against visits of one after another.
#include "contact/solvers/lanes/pgs_lanes.h"

#include <gtest/gtest.h>

#include "core/choices/law.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::solvers {
namespace pgs_lanes_test {

/// Impulses of three sweeps there and three back, and the changes that the sweeps tell.
struct Swept {
  std::vector<double> impulses, changes;
  int in_lanes = 0;  ///< islands
};

Swept sweep_up_and_down(const contact::ContactProblem& problem, const VecX& guess, bool track, bool in_lanes) {
  const contact::PreparedProblem prepared(problem);
  PgsRows rows = make_pgs_rows(prepared, guess, RowOrder::given, 1);
  Swept swept;
  for (const PgsIsland& island : rows.islands) {
    PgsTurns turns(rows, island, track);
    EXPECT_EQ(turns.exist(), island.last - island.first >= 200);
    for (const bool backward : {false, true, false, true, false, true}) {
      const bool turned = in_lanes && turns.exist();
      swept.changes.push_back(turned ? turns.sweep(rows, backward)
                                     : pgs_sweep(rows.law, track)(rows, island, backward));
    }
    if (in_lanes) turns.keep_impulses(rows);
    swept.in_lanes += in_lanes && turns.exist() ? 1 : 0;
  }
  for (const PgsContact& contact : rows.contacts) swept.impulses.insert(swept.impulses.end(), contact.r, contact.r + 3);
  return swept;
}

/// The order of contacts that share a body is kept, and each lane does the arithmetic of a single visit, so the bits
/// are the same. The heaps touch the ground, so some contacts have one body only.
TEST(PgsLanes, GiveTheBitsOfSingleVisits) {
  for (const Law law : {Law::pyramid, Law::coulomb})
    for (const bool track : {false, true}) {
      contact::ContactProblem problem = test::random_heap(7, 90, 601, 0.4);
      problem.law = law;
      problem.compliance[5] = 1e-3;
      problem.force_limit[9] = 0.01;
      const VecX guess = VecX::LinSpaced(3 * problem.num_contacts(), -0.2, 0.3);
      for (const VecX& start : {VecX(), guess}) {
        const Swept lanes = sweep_up_and_down(problem, start, track, true);
        const Swept single = sweep_up_and_down(problem, start, track, false);
        EXPECT_EQ(lanes.impulses, single.impulses);
        EXPECT_EQ(lanes.changes, single.changes);
        EXPECT_EQ(lanes.in_lanes, 1);
      }
    }
}

}  // namespace pgs_lanes_test
}  // namespace nilas::solvers
