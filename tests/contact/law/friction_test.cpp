#include "contact/law/friction.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/error.h"

namespace nilas::contact {
namespace friction_test {

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
  EXPECT_TRUE(table.names("wall", "hull"));
}

TEST(Friction, OfTwoWildcardsTheFirstAddedWins) {
  FrictionTable table;
  table.add("*", "hull", {0.2, 0.2, 0});
  table.add("ice", "*", {0.5, 0.5, 0});
  EXPECT_EQ(table.find("ice", "hull").mu_kinetic, 0.2);
  EXPECT_EQ(table.find("hull", "ice").mu_kinetic, 0.2);
}

TEST(Friction, PairsThatNothingNamesAreFrictionless) {
  FrictionTable table;
  table.add("ice", "ice", {0.3, 0.3, 0});
  EXPECT_EQ(table.find("wall", "ice").mu_static, 0);
  EXPECT_FALSE(table.names("ice", "wall"));
  EXPECT_TRUE(table.names("ice", "ice"));
}

TEST(Friction, AnEntryAddedLaterCounts) {
  FrictionTable table;
  EXPECT_FALSE(table.names("ice", "wall"));
  table.add("wall", "ice", {0.1, 0.1, 0});
  EXPECT_EQ(table.find("ice", "wall").mu_kinetic, 0.1);
  EXPECT_TRUE(table.names("ice", "wall"));
}

TEST(Friction, PairsByNumberAreThoseByName) {
  FrictionTable table;
  table.add("*", "hull", {0.2, 0.1, 0.5});
  table.add("ice", "ice", {0.3, 0.3, 0});
  const std::vector<std::string> materials{"ice", "hull", "wall"};
  const FrictionPairs pairs = table.resolve(materials);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const std::string& first = materials[a];
      const std::string& second = materials[b];
      EXPECT_EQ(pairs.of(a, b).mu_static, table.find(first, second).mu_static);
      EXPECT_EQ(pairs.of(a, b).restitution, table.find(first, second).restitution);
      EXPECT_EQ(pairs.names(a, b), table.names(first, second));
    }
  EXPECT_THROW(pairs.of(0, 3), ContractError);
  EXPECT_THROW(pairs.of(-1, 0), ContractError);
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

}  // namespace friction_test
}  // namespace nilas::contact
