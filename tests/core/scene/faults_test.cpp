/// Every fault of a scene is reported with its place and its remedy.
#include <gtest/gtest.h>

#include <set>

#include "core/scene/spec/values.h"
#include "tests/core/scene/complete_scene.h"

namespace nilas::scene {
namespace faults_test {

using testing::expect_fault;
using testing::in_scene;
using testing::SceneFolder;

TEST(Faults, FiveDifferentFaultsAreFiveMessagesWithPlaces) {
  const SceneFolder folder;
  const auto faults = folder.faults(R"(<scene version="1" name="bad">
  <time step="-0.01" end="60"/>
  <contact law="coulom" tolerence="1e-6"/>
  <vessel hull="missing/hull" position="0 0 0"><mass value="1500"/></vessel>
  <bodie name="box"/>
</scene>)");
  ASSERT_EQ(faults.size(), 5u) << testing::text_of(faults);
  const std::string file = (folder.path() / "scene.xml").string();
  EXPECT_EQ(faults[0].text(), file + ":2:9: <time step>: found '-0.01'; allowed: a finite number > 0 [s]");
  EXPECT_EQ(faults[1].text(), file +
                                  ":3:12: <contact law>: found 'coulom'; allowed: one of coulomb, ccp, pyramid, "
                                  "pyramid-k, frictionless; nearest: coulomb");
  EXPECT_EQ(faults[2].line, 3);
  EXPECT_EQ(faults[2].column, 25);
  EXPECT_NE(faults[2].message.find("nearest: tolerance"), std::string::npos) << faults[2].message;
  EXPECT_EQ(faults[3].text(),
            file + ":4:11: <vessel hull>: " + (folder.path() / "missing/hull").string() + ": there is no such file");
  EXPECT_EQ(faults[4].line, 5);
  EXPECT_EQ(faults[4].column, 3);
  EXPECT_NE(faults[4].message.find("nearest: body"), std::string::npos) << faults[4].message;
}

TEST(Faults, ColumnsAreThoseOfTheAttributeOrItsElement) {
  const SceneFolder folder;
  const auto faults = folder.faults(
      "<scene version='1' name='größe'><!-- <time step='x'/> --><time step='x'\n"
      "\tend =  'y'/><gravity value='step=0'/></scene>");
  ASSERT_EQ(faults.size(), 3u) << testing::text_of(faults);
  EXPECT_EQ(faults[0].line, 1);
  EXPECT_EQ(faults[0].column, 64) << "behind the comment, counting characters";
  EXPECT_EQ(faults[1].line, 2);
  EXPECT_EQ(faults[1].column, 2);
  EXPECT_EQ(faults[2].column, 23);
}

TEST(Faults, MissingAttributesStandAtTheirElement) {
  const SceneFolder folder;
  expect_fault(folder.faults(in_scene("<tank length='1' width='2'/>")), 2, "<tank depth>", {"missing", "> 0 [m]"});
  expect_fault(folder.faults("<scene/>"), 1, "<scene version>", {"missing", "allowed: 1"});
  expect_fault(folder.faults(in_scene("<ice><floe/></ice>")), 2, "<ice><floe outline>", {"missing"});
}

TEST(Faults, AMisspeltRequiredAttributeIsOneFault) {
  const SceneFolder folder;
  expect_fault(folder.faults(in_scene("<tank lenght='1' width='2' depth='1'/>")), 2, "<tank lenght>",
               {"unknown attribute", "nearest: length"});
}

/// What a misspelt element would have provided is not reported as missing elsewhere.
TEST(Faults, AMisspeltElementIsOneFault) {
  const SceneFolder folder;
  const auto fault = [&](const std::string& content, const std::string& where, const std::string& nearest) {
    SCOPED_TRACE(content);
    expect_fault(folder.faults(in_scene(content)), 2, where, {"unknown element here", "nearest: " + nearest});
  };
  const std::string breaks =
      "<ice><floe breakable='true' outline='0 0 1 0 1 1'/></ice><fracture><bending/><splitting/></fracture>";
  fault("<water/><hydro><bouyancy/></hydro>" + breaks, "<hydro><bouyancy>", "buoyancy");
  fault("<water/><hidro><buoyancy/></hidro>" + breaks, "<hidro>", "hydro");
  fault("<vessel><hull/><mas value='1500'/></vessel>", "<vessel><mas>", "mass");
  fault("<water/><vessel position='0 0'><hull/><mas value='1500'/></vessel>", "<vessel><mas>", "mass");
  fault("<vessel position='0 0 0'><hull/><mas value='1500'/><part name='a' joint='weld' density='1000'/></vessel>",
        "<vessel><mas>", "mass");
  fault("<ice><field region='0 0 1 1'><size distribution='as-library'/><shap library='floes.json'/></field></ice>",
        "<ice><field><shap>", "shape");
  expect_fault(folder.faults(in_scene("<water/><hydro><drag/></hydro>"
                                      "<ice><floe breakable='true' outline='0 0 1 0 1 1'/></ice>"
                                      "<fracture><bending/></fracture>")),
               2, "<fracture><bending>", {"with <hydro><buoyancy>"});
}

TEST(Faults, AmericanSpellingIsOneFault) {
  const SceneFolder folder;
  expect_fault(folder.faults(in_scene("<water/><vessel position='0 0'><hull/><mass draft='0.4'/></vessel>")), 2,
               "<vessel><mass draft>", {"unknown attribute", "nearest: draught"});
}

TEST(Faults, AnotherVersionIsAClearError) {
  const SceneFolder folder;
  expect_fault(folder.faults("<scene version='2'/>"), 1, "<scene version>", {"found '2'", "allowed: 1"});
}

TEST(Faults, OneTooManyAndWrongPlaces) {
  const SceneFolder folder;
  expect_fault(folder.faults(in_scene("<seed value='1'/>\n<seed value='2'/>")), 3, "<seed>", {"second", "one <seed>"});
  expect_fault(folder.faults(in_scene("<friction between='ice ice' static='0'/>")), 2, "<friction>",
               {"unknown element", "belongs in <contact>"});
  expect_fault(folder.faults(in_scene("<water><watr/></water>")), 2, "<water><watr>", {"allowed: current, waves"});
}

TEST(Faults, TextHasNoPlaceInAScene) {
  const SceneFolder folder;
  expect_fault(folder.faults(in_scene("<time end='2'>\n  ten seconds\n</time>")), 3, "<time>", {"found text"});
  EXPECT_TRUE(folder.faults(in_scene("<time end='2'>\n  <!-- ten --> \n</time>")).empty());
}

TEST(Faults, ValuesOfEveryType) {
  const SceneFolder folder;
  const auto fault = [&](const std::string& content, const std::string& where, const std::vector<std::string>& words) {
    expect_fault(folder.faults(in_scene(content)), 2, where, words);
  };
  fault("<time step='1e-2 s'/>", "<time step>", {"found 's'", "a finite number > 0 [s]"});
  fault("<time step='0.1 0.2'/>", "<time step>", {"found '0.1 0.2'"});
  fault("<time step='4.9e-324' end='1'/>", "<time step>", {"more than", "steps"});
  fault("<time step=''/>", "<time step>", {"found ''"});
  fault("<gravity value='0 0'/>", "<gravity value>", {"found 2 numbers", "3 finite numbers [m/s^2]"});
  fault("<gravity value='0,0,-9.81'/>", "<gravity value>", {"found '0,0,-9.81'", "blanks separate"});
  fault("<seed value='1.5'/>", "<seed value>", {"a whole number"});
  fault("<seed value='-1'/>", "<seed value>", {">= 0"});
  fault("<contact gyroscopic='yes'/>", "<contact gyroscopic>", {"true or false"});
  fault("<contact law='pyramid-2'/>", "<contact law>", {"found 'pyramid-2'"});
  fault("<contact erp='1.5'/>", "<contact erp>", {">= 0 and <= 1"});
  fault("<body name='a,b'/>", "<body name>", {"a name without"});
  fault("<body material='two words'/>", "<body material>", {"one word"});
  fault("<ice poisson='0.6'/>", "<ice poisson>", {"<= 0.5"});
  fault("<body mass='-5'/>", "<body mass>", {"found '-5'", "> 0 [kg]"});
  fault("<ice><field kind='file' file=''/></ice>", "<ice><field file>", {"the path of a file"});
}

/// Texts that look like numbers, and the results of a strict reader.
TEST(Faults, StrangeNumbers) {
  for (const char* text :
       {"nan",   "NaN", "-nan",  "nan(1)", "inf", "-inf", "Infinity", "1e999",     "-1e999", "1e", "e1",  "1e+", "0x10",
        "1.2.3", "1,5", "--1",   "+-1",    "-+1", "+",    "-",        ".",         "",       " ",  "1 2", "1d3", "1f",
        "1_0",   "１",  "1e5.5", "½",      "1;",  "0b1",  "true",     "1\xC2\xA0", "1e-400", "$1", "∞"})
    EXPECT_FALSE(parse_number(text)) << "'" << text << "'";
  const std::vector<std::pair<std::string, double>> good{{"1", 1},
                                                         {"+1", 1},
                                                         {"-1", -1},
                                                         {" 2 ", 2},
                                                         {"1.", 1},
                                                         {".5", 0.5},
                                                         {"1E3", 1000},
                                                         {"1e+3", 1000},
                                                         {"007", 7},
                                                         {"-0", -0.0},
                                                         {"1e-3", 0.001},
                                                         {"4.9e-324", 4.9e-324},
                                                         {"1.7976931348623157e308", 1.7976931348623157e308},
                                                         {"0.1000000000000000055511151231257827", 0.1},
                                                         {"\t3\n", 3}};
  for (const auto& [text, value] : good) EXPECT_EQ(parse_number(text), value) << text;
}

TEST(Faults, RandomBytesAreNeverTakenForNumbersTheyAreNot) {
  const std::string alphabet = "0123456789+-.eExX naifINF,_";
  std::uint64_t state = 1;
  for (int trial = 0; trial < 20000; ++trial) {
    std::string text;
    for (std::uint64_t length = state % 7; text.size() < length;) {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      text += alphabet[(state >> 33U) % alphabet.size()];
    }
    state += 0x9E3779B97F4A7C15ULL;
    state ^= state >> 29U;
    const auto value = parse_number(text);
    if (!value) continue;
    EXPECT_TRUE(std::isfinite(*value)) << text;
    EXPECT_EQ(trimmed(text).find_first_not_of("0123456789+-.eE"), std::string::npos) << "'" << text << "'";
    EXPECT_EQ(parse_number(format_number(*value)), *value) << text;
  }
}

TEST(Faults, NumbersAreWrittenShortAndExactly) {
  EXPECT_EQ(format_number(0.1), "0.1");
  EXPECT_EQ(format_number(1e-6), "1e-06");
  EXPECT_EQ(parse_number(format_number(1.0 / 3)), 1.0 / 3);
  EXPECT_EQ(parse_number(format_number(-1.7976931348623157e308)), -1.7976931348623157e308);
}

}  // namespace faults_test
}  // namespace nilas::scene
