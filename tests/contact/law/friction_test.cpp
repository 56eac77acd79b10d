#include "contact/law/friction.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/error.h"

namespace nilas {
namespace {

TEST(Friction, ExactPairWinsOverOneWildcardOverTwo) {
  FrictionTable table;
  table.add("*", "*", {0.9, 0.9, 0});
  table.add("ice", "*", {0.5, 0.4, 0});
  table.add("hull", "ice", {0.12, 0.10, 0.3});
  EXPECT_EQ(table.find("ice", "hull").mu_kinetic, 0.10);
  EXPECT_EQ(table.find("hull", "ice").mu_static, 0.12);
  EXPECT_EQ(table.find("hull", "ice").restitution, 0.3);
  EXPECT_EQ(table.find("wall", "ice").mu_kinetic, 0.4);
  EXPECT_EQ(table.find("ice", "ice").mu_kinetic, 0.4);
  EXPECT_EQ(table.find("wall", "hull").mu_kinetic, 0.9);
  EXPECT_TRUE(table.unnamed_pairs().empty());
}

TEST(Friction, OfTwoWildcardsTheFirstAddedWins) {
  FrictionTable table;
  table.add("*", "hull", {0.2, 0.2, 0});
  table.add("ice", "*", {0.5, 0.5, 0});
  EXPECT_EQ(table.find("ice", "hull").mu_kinetic, 0.2);
  EXPECT_EQ(table.find("hull", "ice").mu_kinetic, 0.2);
}

TEST(Friction, UnnamedPairsAreFrictionlessAndRememberedOnce) {
  FrictionTable table;
  table.add("ice", "ice", {0.3, 0.3, 0});
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(table.find("wall", "ice").mu_static, 0);
    EXPECT_EQ(table.find("ice", "wall").mu_static, 0);
    EXPECT_EQ(table.find("ice", "ice").mu_static, 0.3);
  }
  const std::vector<std::pair<std::string, std::string>> expected{{"ice", "wall"}};
  EXPECT_EQ(table.unnamed_pairs(), expected);
}

TEST(Friction, AnEntryAddedLaterCounts) {
  FrictionTable table;
  EXPECT_EQ(table.find("ice", "wall").mu_kinetic, 0);
  table.add("wall", "ice", {0.1, 0.1, 0});
  EXPECT_EQ(table.find("ice", "wall").mu_kinetic, 0.1);
  EXPECT_TRUE(table.unnamed_pairs().empty());
}

TEST(Friction, RefusesWrongValues) {
  FrictionTable table;
  EXPECT_THROW(table.add("a", "b", {0.1, 0.2, 0}), InputError);
  EXPECT_THROW(table.add("a", "b", {0.1, -0.2, 0}), InputError);
  EXPECT_THROW(table.add("a", "b", {std::numeric_limits<double>::infinity(), 0.2, 0}), InputError);
  EXPECT_THROW(table.add("a", "b", {0.2, 0.2, 1.1}), InputError);
  table.add("a", "b", {0.2, 0.2, 1});
  EXPECT_THROW(table.add("b", "a", {0.3, 0.2, 0}), InputError);
}

}  // namespace
}  // namespace nilas
