#include "core/base/error.h"

#include <gtest/gtest.h>

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
