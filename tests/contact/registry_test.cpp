#include "contact/registry.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "tests/support/problems/cone_problems.h"
#include "tests/support/refusal.h"

namespace nilas::contact {
namespace registry_test {

TEST(Registry, FindsSolversAndNamesTheNearest) {
  EXPECT_EQ(find_solver("pgs").make({})->name(), "pgs");
  EXPECT_EQ(find_solver("auto").make({})->name(), "auto");
  EXPECT_EQ(find_solver("newton").make({})->name(), "newton");
  const std::string message = test::refusal([] { find_solver("pgz"); });
  EXPECT_NE(message.find("did you mean 'pgs'"), std::string::npos) << message;
}

/// Velocity of a particle that has hit a floor at (-1, 3, 0) with friction 0.5.
Vec3 after_oblique_impact(Law law) {
  if (law == Law::frictionless) return {0, 3, 0};
  if (law == Law::ccp) return {1, 2, 0};  // The particle lifts off: u_N = mu |u_T|.
  return {0, 2.5, 0};                     // A corner of the polygon and a side of the box lie along the slip.
}

TEST(Registry, EveryEntrySolvesEveryLawItNames) {
  for (const auto& entry : solver_registry()) {
    EXPECT_FALSE(entry.summary.empty()) << entry.name;
    EXPECT_FALSE(entry.laws.empty()) << entry.name;
    const auto solver = entry.make({.tolerance = 1e-8, .max_iterations = 10000});
    EXPECT_EQ(solver->name(), entry.name);
    for (const Law law : entry.laws) {
      const ContactSolution solution = solver->solve(test::particle(law, 2, 0.5, {-1, 3, 0}), {});
      EXPECT_EQ(solution.status, SolveStatus::converged) << entry.name << " " << to_string(law);
      EXPECT_LT((solution.v - after_oblique_impact(law)).norm(), 1e-7) << entry.name << " " << to_string(law);
    }
  }
}

TEST(Registry, EntriesRefuseLawsTheyDoNotName) {
  for (const auto& entry : solver_registry())
    for (const Law law : {Law::coulomb, Law::ccp, Law::pyramid, Law::pyramid_k, Law::frictionless}) {
      if (std::find(entry.laws.begin(), entry.laws.end(), law) != entry.laws.end()) continue;
      EXPECT_THROW(entry.make({})->solve(test::particle(law, 2, 0.5, {-1, 3, 0}), {}), InputError)
          << entry.name << " " << to_string(law);
    }
}

TEST(Registry, ParsesLaws) {
  EXPECT_EQ(parse_law("coulomb").law, Law::coulomb);
  EXPECT_EQ(parse_law("ccp").law, Law::ccp);
  EXPECT_EQ(parse_law("pyramid").law, Law::pyramid);
  EXPECT_EQ(parse_law("frictionless").law, Law::frictionless);
  EXPECT_EQ(parse_law("pyramid-8").law, Law::pyramid_k);
  EXPECT_EQ(parse_law("pyramid-8").facets, 8);
  EXPECT_EQ(parse_law("pyramid-16").facets, 16);
}

TEST(Registry, RefusesWrongLawsWithTheNearest) {
  EXPECT_NE(test::refusal([] { parse_law("coulob"); }).find("did you mean 'coulomb'"), std::string::npos);
  EXPECT_NE(test::refusal([] { parse_law("pyramid-2"); }).find("3 to 1000 facets"), std::string::npos);
  EXPECT_NE(test::refusal([] { parse_law("pyramid-k"); }).find("facets"), std::string::npos);
  EXPECT_NE(test::refusal([] { parse_law("pyramid-8x"); }).find("unknown"), std::string::npos);
  EXPECT_NE(test::refusal([] { parse_law(""); }).find("known: coulomb"), std::string::npos);
}

TEST(Registry, NamesOfLawsAndStatuses) {
  EXPECT_STREQ(to_string(Law::pyramid_k), "pyramid-k");
  EXPECT_STREQ(to_string(SolveStatus::converged), "converged");
  EXPECT_STREQ(to_string(SolveStatus::iteration_limit), "iteration_limit");
  EXPECT_STREQ(to_string(SolveStatus::stalled), "stalled");
  EXPECT_STREQ(to_string(SolveStatus::numerical_error), "numerical_error");
}

}  // namespace registry_test
}  // namespace nilas::contact
