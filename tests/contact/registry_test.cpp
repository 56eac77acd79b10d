#include "contact/registry.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace nilas {
namespace {

template <class Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Registry, FindsSolversAndNamesTheNearest) {
  EXPECT_EQ(find_solver("pgs").make({})->name(), "pgs");
  EXPECT_EQ(find_solver("auto").make({})->name(), "auto");
  EXPECT_EQ(find_solver("newton").make({})->name(), "newton");
  const std::string message = message_of([] { find_solver("pgz"); });
  EXPECT_NE(message.find("did you mean 'pgs'"), std::string::npos) << message;
}

TEST(Registry, EveryEntryCanBeMade) {
  for (const auto& entry : solver_registry()) {
    EXPECT_FALSE(entry.summary.empty());
    EXPECT_FALSE(entry.laws.empty());
    const auto solution = entry.make({})->solve(ContactProblem{}, {});
    EXPECT_EQ(solution.status, SolveStatus::converged);
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
  EXPECT_NE(message_of([] { parse_law("coulob"); }).find("did you mean 'coulomb'"), std::string::npos);
  EXPECT_NE(message_of([] { parse_law("pyramid-2"); }).find("3 to 1000 facets"), std::string::npos);
  EXPECT_NE(message_of([] { parse_law("pyramid-k"); }).find("facets"), std::string::npos);
  EXPECT_NE(message_of([] { parse_law("pyramid-8x"); }).find("unknown"), std::string::npos);
  EXPECT_NE(message_of([] { parse_law(""); }).find("known: coulomb"), std::string::npos);
}

TEST(Registry, NamesOfLawsAndStatuses) {
  EXPECT_STREQ(to_string(Law::pyramid_k), "pyramid-k");
  EXPECT_STREQ(to_string(SolveStatus::converged), "converged");
  EXPECT_STREQ(to_string(SolveStatus::iteration_limit), "iteration_limit");
  EXPECT_STREQ(to_string(SolveStatus::stalled), "stalled");
  EXPECT_STREQ(to_string(SolveStatus::numerical_error), "numerical_error");
}

}  // namespace
}  // namespace nilas
