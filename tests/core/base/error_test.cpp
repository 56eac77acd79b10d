#include "core/base/error.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/refusal.h"

namespace nilas {
namespace error_test {

TEST(Fault, TextNamesWhatIsKnown) {
  EXPECT_EQ((Fault{"a.xml", 3, 7, "<floe>", "is wrong"}.text()), "a.xml:3:7: <floe>: is wrong");
  EXPECT_EQ((Fault{"a.xml", 3, 0, "<floe>", "is wrong"}.text()), "a.xml:3: <floe>: is wrong");
  EXPECT_EQ((Fault{"a.xml", 0, 7, "", "is wrong"}.text()), "a.xml: is wrong");
  EXPECT_EQ((Fault{"", 0, 0, "", "is wrong"}.text()), "is wrong");
}

TEST(SceneError, CarriesEveryFaultOneLineEach) {
  const SceneError error({{"a.xml", 1, 2, "", "first"}, {"a.xml", 5, 1, "<step>", "second"}});
  EXPECT_EQ(std::string(error.what()), "a.xml:1:2: first\na.xml:5:1: <step>: second");
  ASSERT_EQ(error.faults().size(), 2u);
  EXPECT_EQ(error.faults()[1].line, 5);
}

TEST(Demand, ThrowsWithExpressionAndPlace) {
  NILAS_DEMAND(1 + 1 == 2);
  test::expect_refusal<ContractError>([] { NILAS_DEMAND(1 + 1 == 3); }, {"1 + 1 == 3", "error_test.cpp:"});
}

TEST(NearestName, FindsSlipsOfTheFinger) {
  const std::vector<std::string> names{"friction", "restitution", "velocity", "density", "mass"};
  EXPECT_EQ(nearest_name("fricton", names), "friction");
  EXPECT_EQ(nearest_name("veloctiy", names), "velocity");
  EXPECT_EQ(nearest_name("desnity", names), "density");
  EXPECT_EQ(nearest_name("mas", names), "mass");
  EXPECT_EQ(nearest_name("mass", names), "mass");
  EXPECT_EQ(nearest_name("bouyancy", {"drag", "buoyancy"}), "buoyancy");
  EXPECT_EQ(nearest_name("rnu", {"run"}), "run") << "letters that change places are one slip";
}

/// In "r1" and "ci" no letter is the same, and in "tank" and "mass" one of four is.
TEST(NearestName, OfShortNamesMostLettersMustAgree) {
  EXPECT_EQ(nearest_name("r1", {"ci", "runs"}), "");
  EXPECT_EQ(nearest_name("r1", {"ci", "r2"}), "r2");
  EXPECT_EQ(nearest_name("x", {"y", "xy"}), "");
  EXPECT_EQ(nearest_name("tank", {"mass"}), "");
}

/// Editing a name into one of half its length takes more edits than are allowed.
TEST(NearestName, OfAMegabyteIsFoundAtOnce) {
  const std::vector<std::string> names(1000, "thickness");
  EXPECT_EQ(nearest_name(std::string(1 << 20, 't'), names), "");
  EXPECT_EQ(nearest_name("thickness_m", {"thickness"}), "thickness");
  EXPECT_EQ(nearest_name("pull", {"pull_of_the_propeller_in_N"}), "pull_of_the_propeller_in_N");
}

TEST(SceneError, ShowsTwoHundredFaultsAndCountsTheOthers) {
  std::vector<Fault> faults(1000, Fault{"s.xml", 1, 2, "<ice>", "wrong"});
  const SceneError error(faults);
  const std::string said = error.what();
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 200);
  EXPECT_NE(said.find("800 further faults"), std::string::npos);
  EXPECT_EQ(error.faults().size(), 1000U);
}

TEST(Fault, ALongValueIsCutInTheMiddle) {
  const Fault fault{"s.xml", 1, 2, "<ice>", "found " + std::string(1 << 20, '1') + "; allowed: > 0"};
  EXPECT_LT(fault.text().size(), 2100U);
  EXPECT_NE(fault.text().find("found 111"), std::string::npos);
  EXPECT_NE(fault.text().find("allowed: > 0"), std::string::npos);
}

TEST(NearestName, KnowsAmericanSpelling) {
  EXPECT_EQ(nearest_name("draft", {"value", "cog", "draught"}), "draught");
  EXPECT_EQ(nearest_name("draft", {"value", "cog"}), "");
}

TEST(NearestName, SaysNothingWhenNothingIsClose) {
  EXPECT_EQ(nearest_name("draught", {"friction", "restitution"}), "");
  EXPECT_EQ(nearest_name("mass", {}), "");
}

TEST(NearestName, TheFirstOfEquallyNearNamesWins) { EXPECT_EQ(nearest_name("bat", {"cat", "hat"}), "cat"); }

}  // namespace error_test
}  // namespace nilas
