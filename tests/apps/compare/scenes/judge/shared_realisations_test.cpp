/// Which realisations means are taken over.
#include "apps/compare/scenes/judge/shared_realisations.h"

#include <gtest/gtest.h>

namespace shared_realisations_test {

using namespace nilas;
using namespace nilas::compare;
using Numbers = std::vector<int>;

/// `counts`: settings with all realisations done, and with the first alone.
std::vector<DoneRuns> settings(std::size_t with_both, std::size_t with_one) {
  std::vector<DoneRuns> all(with_both, DoneRuns{{true, true}});
  all.insert(all.end(), with_one, DoneRuns{{true, false}});
  return all;
}

TEST(SharedRealisations, AreThoseThatAllHave) {
  EXPECT_EQ(shared_realisations(settings(4, 0), {true, true}), (Numbers{0, 1}));
  EXPECT_EQ(shared_realisations(settings(1, 3), {true, true}), (Numbers{0}));
}

TEST(SharedRealisations, CountWhereThreeQuartersHaveThem) {
  EXPECT_EQ(shared_realisations(settings(3, 1), {true, true}), (Numbers{0, 1}));
  EXPECT_EQ(shared_realisations(settings(5, 2), {true, true}), (Numbers{0}));
}

TEST(SharedRealisations, AreNotTakenAwayByASettingThatFailedOrNeverRan) {
  auto all = settings(2, 2);
  for (std::size_t k : {2U, 3U}) all[k].failed = true;
  EXPECT_EQ(shared_realisations(all, {true, true}), (Numbers{0, 1}));
  all = settings(2, 0);
  all.insert(all.end(), 5, DoneRuns{{false, false}});
  EXPECT_EQ(shared_realisations(all, {true, true}), (Numbers{0, 1}));
}

TEST(SharedRealisations, AreThoseThatCanBeJudgedAndHaveTheFirstSetting) {
  EXPECT_EQ(shared_realisations(settings(4, 0), {false, true}), (Numbers{1}));
  EXPECT_EQ(shared_realisations(settings(4, 0), {false, false}), (Numbers{0, 1})) << "none can be judged";
  auto all = settings(4, 0);
  all.front().done = {true, false};
  EXPECT_EQ(shared_realisations(all, {true, true}), (Numbers{0}));
}

TEST(SharedRealisations, AreTheOneWithTheMostWhereNoneHasEnough) {
  std::vector<DoneRuns> all{{{true, true, true}},
                            {{true, false, false}},
                            {{false, true, false}},
                            {{false, true, false}},
                            {{false, false, true}}};
  EXPECT_EQ(shared_realisations(all, {true, true, true}), (Numbers{1}));
  EXPECT_TRUE(shared_realisations({{{false, false}}}, {false, false}).empty());
  EXPECT_TRUE(shared_realisations({}, {}).empty());
}

}  // namespace shared_realisations_test
