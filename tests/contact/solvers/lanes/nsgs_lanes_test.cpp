/// Contacts solved four at a time against contacts solved one after another.
#include "contact/solvers/lanes/nsgs_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "contact/solvers/shared/sweep_momentum.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::solvers {
namespace nsgs_lanes_test {

/// Impulses of three sweeps there and three back, and the changes that the sweeps tell.
struct Swept {
  std::vector<double> impulses, changes;
  int in_lanes = 0;  ///< islands
};

/// Places of all contacts of an island.
std::vector<int> all_of(const PgsIsland& island) {
  std::vector<int> places(static_cast<std::size_t>(island.last - island.first));
  std::iota(places.begin(), places.end(), island.first);
  return places;
}

/// The same number of sweeps with momentum.
Swept sweep_with_momentum(const contact::ContactProblem& problem, const VecX& guess, bool in_lanes) {
  const contact::PreparedProblem prepared(problem);
  PgsRows rows = make_pgs_rows(prepared, guess, RowOrder::coloured, 1);
  RowResidual residual(problem, prepared.masses(), 1);
  Swept swept;
  for (const PgsIsland& island : rows.islands) {
    std::vector<NsgsContact> blocks = make_nsgs_contacts(rows, island);
    NsgsTurns turns(rows, island, blocks);
    const bool turned = in_lanes && turns.exist();
    SweepMomentum momentum({problem, prepared.masses(), rows, island, residual, 1},
                           turned ? turns.alone(island) : all_of(island));
    double most = 0;
    for (int k = 0; k < 12; ++k) {
      const double beta = momentum.push();
      most = std::max(most, beta);
      turns.set_momentum(beta);
      swept.changes.push_back(turned ? turns.sweep(rows, island, blocks, false, 1)
                                     : nsgs_sweep(rows, island, blocks, problem.facets, false, 1));
    }
    EXPECT_GT(most, 0.1);
    if (turned) turns.keep_impulses(rows);
    swept.in_lanes += turned ? 1 : 0;
  }
  for (const PgsContact& contact : rows.contacts) swept.impulses.insert(swept.impulses.end(), contact.r, contact.r + 3);
  return swept;
}

Swept sweep_up_and_down(const contact::ContactProblem& problem, const VecX& guess, bool in_lanes) {
  const contact::PreparedProblem prepared(problem);
  PgsRows rows = make_pgs_rows(prepared, guess, RowOrder::coloured, 1);
  Swept swept;
  for (const PgsIsland& island : rows.islands) {
    std::vector<NsgsContact> blocks = make_nsgs_contacts(rows, island);
    NsgsTurns turns(rows, island, blocks);
    const bool turned = in_lanes && turns.exist();
    for (const bool backward : {false, true, false, true, false, true}) {
      swept.changes.push_back(turned ? turns.sweep(rows, island, blocks, backward, 2)
                                     : nsgs_sweep(rows, island, blocks, problem.facets, backward, 1));
    }
    if (turned) turns.keep_impulses(rows);
    swept.in_lanes += turned ? 1 : 0;
  }
  for (const PgsContact& contact : rows.contacts) swept.impulses.insert(swept.impulses.end(), contact.r, contact.r + 3);
  return swept;
}

/// A heap on the ground, in which contacts have one body or two, no friction, a force limit or compliance.
contact::ContactProblem mixed_heap(unsigned seed, double friction) {
  contact::ContactProblem problem = test::random_heap(seed, 150, 1301, friction);
  problem.law = Law::coulomb;
  for (std::size_t c = 0; c < problem.mu.size(); ++c) {
    if (c % 11 == 5) problem.mu[c] = 0;
    if (c % 13 == 7) problem.force_limit[c] = 0.01;
    if (c % 17 == 3) problem.compliance[c] = 1e-3;
    if (c % 19 == 4) problem.tangential_compliance[c] = 1e-2;
  }
  return problem;
}

TEST(NsgsLanes, GiveTheBitsOfSingleVisits) {
  for (const unsigned seed : {3U, 7U})
    for (const double friction : {0.05, 0.4, 3.0}) {
      const contact::ContactProblem problem = mixed_heap(seed, friction);
      const VecX guess = VecX::LinSpaced(3 * problem.num_contacts(), -0.2, 0.3);
      for (const VecX& start : {VecX(), guess}) {
        const Swept lanes = sweep_up_and_down(problem, start, true);
        const Swept single = sweep_up_and_down(problem, start, false);
        EXPECT_EQ(lanes.impulses, single.impulses);
        EXPECT_EQ(lanes.changes, single.changes);
        EXPECT_EQ(lanes.in_lanes, 1);
      }
    }
}

TEST(NsgsLanes, KeepTheirBitsWithMomentum) {
  const contact::ContactProblem problem = mixed_heap(7, 0.4);
  const Swept lanes = sweep_with_momentum(problem, VecX(), true);
  const Swept single = sweep_with_momentum(problem, VecX(), false);
  EXPECT_EQ(lanes.impulses, single.impulses);
  EXPECT_EQ(lanes.changes, single.changes);
  EXPECT_EQ(lanes.in_lanes, 1);
}

TEST(NsgsLanes, AreForCoulombsLawAlone) {
  for (const Law law : {Law::ccp, Law::pyramid, Law::frictionless}) {
    contact::ContactProblem problem = test::random_heap(7, 150, 1301, 0.4);
    problem.law = law;
    const contact::PreparedProblem prepared(problem);
    const PgsRows rows = make_pgs_rows(prepared, VecX(), RowOrder::coloured, 1);
    EXPECT_FALSE(NsgsTurns(rows, rows.islands[0], make_nsgs_contacts(rows, rows.islands[0])).exist());
  }
}

}  // namespace nsgs_lanes_test
}  // namespace nilas::solvers
