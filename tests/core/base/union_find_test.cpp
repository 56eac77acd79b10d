#include "core/base/union_find.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace nilas {
namespace union_find_test {

using Groups = std::vector<std::vector<int>>;

TEST(UnionFind, NothingIsJoinedAtFirst) {
  EXPECT_EQ(UnionFind(3).groups(), (Groups{{0}, {1}, {2}}));
  EXPECT_TRUE(UnionFind(0).groups().empty());
}

TEST(UnionFind, GroupsComeByTheirFirstMember) {
  UnionFind things(6);
  things.join(5, 1);
  things.join(4, 2);
  things.join(1, 3);
  EXPECT_EQ(things.groups(), (Groups{{0}, {1, 3, 5}, {2, 4}}));
  EXPECT_EQ(things.find(3), things.find(5));
  EXPECT_NE(things.find(3), things.find(4));
}

TEST(UnionFind, JoiningTwiceChangesNothing) {
  UnionFind things(3);
  for (int k = 0; k < 3; ++k) things.join(2, 0);
  things.join(1, 1);
  EXPECT_EQ(things.groups(), (Groups{{0, 2}, {1}}));
}

TEST(UnionFind, PlacesOfThingsThatStandOftenOrNowhere) {
  UnionFind things(5);
  things.join(0, 4);
  constexpr std::size_t none = UnionFind::k_nothing;
  EXPECT_EQ(things.groups_of({4, none, 2, 0, none, 2}), (Groups{{0, 3}, {1}, {2, 5}, {4}}));
}

/// The reference is a list of labels that are changed one by one.
TEST(UnionFind, RandomJoinsAgreeWithLabels) {
  RandomStream random(1, "joins");
  constexpr std::size_t count = 200;
  UnionFind things(count);
  std::vector<std::size_t> label(count);
  std::iota(label.begin(), label.end(), std::size_t{0});
  for (int k = 0; k < 150; ++k) {
    const std::size_t a = random.bits() % count, b = random.bits() % count;
    things.join(a, b);
    const std::size_t from = label[b], to = label[a];
    for (std::size_t& each : label)
      if (each == from) each = to;
    for (std::size_t i = 0; i < count; i += 7) EXPECT_EQ(things.find(i) == things.find(a), label[i] == label[a]);
  }
}

}  // namespace union_find_test
}  // namespace nilas
