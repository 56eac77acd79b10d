/// Words of the command line: several values of --set, misspelt commands and flags.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/support/mentions.h"
#include "tests/support/program.h"

namespace usage_test {

using namespace nilas_test;

constexpr const char* k_box = R"(<scene version="1" name="box">
  <time step="0.01" end="0.05"/>
  <contact solver="pgs" tolerance="1e-9"><friction between="structure structure" static="0.3" kinetic="0.3"/></contact>
  <body name="ground" shape="plane" fixed="true"/>
  <body name="box" shape="box" size="1 1 1" mass="2" position="0 0 0.5" velocity="1 0 0"/>
</scene>
)";

class Usage : public ::testing::Test {
 protected:
  Usage() { folder.write("box.xml", k_box); }
  ProgramResult nilas(const std::string& words) const { return run_nilas(words, folder.path()); }
  /// The command is refused with these words.
  void expect_refusal(const std::string& command, const std::vector<std::string>& words) const {
    const auto result = nilas(command);
    EXPECT_EQ(result.exit_code, 2) << command;
    EXPECT_EQ(result.out, "") << command;
    std::string text = result.err;
    std::replace(text.begin(), text.end(), '\n', ' ');
    for (const auto& word : words) EXPECT_TRUE(mentions(text, word)) << command << ": " << result.err;
  }

  ScratchFolder folder;
};

TEST_F(Usage, SetTakesSeveralValuesAndNoScene) {
  const std::string mass = "\"body[@name='box']/@mass=3\"", step = "time/@step=0.005", end = "time/@end=0.02";
  for (const std::string& words :
       {"box.xml --set " + mass + " " + step + " " + end, "--set " + mass + " " + step + " " + end + " box.xml",
        "--set " + mass + " " + step + " box.xml --set " + end,
        "--set=" + mass + " " + step + " --set " + end + " box.xml",
        "--set " + end + " --until 0.02 --set " + step + " " + mass + " -- box.xml"}) {
    const auto result = nilas("run --json --force --out run " + words);
    ASSERT_EQ(result.exit_code, 0) << words << ": " << result.err;
    EXPECT_EQ(nlohmann::json::parse(result.out)["steps"], 4) << words;
    EXPECT_TRUE(mentions(read_text(folder.path() / "run/scene.xml"), "mass=\"3\"")) << words;
  }
}

TEST_F(Usage, SetTakesSeveralValuesInEveryCommandThatHasIt) {
  EXPECT_EQ(nilas("check --set time/@step=0.005 time/@end=0.02 box.xml").exit_code, 0);
  folder.write("ice.xml", "<scene version='1'><ice><floe outline='0 0 1 0 1 1'/></ice></scene>");
  const auto field = nilas("field --json --no-picture --set ice/@thickness=0.2 ice/@density=800 ice.xml");
  EXPECT_EQ(field.exit_code, 0) << field.err;
  expect_refusal("compare --set contact/@tolerence=1 time/@stop=2 box.xml", {"nearest: tolerance", "nearest: step"});
}

TEST_F(Usage, SetNamesTheValueThatIsNoOverride) {
  expect_refusal("run box.xml --set time/@end=0.02 contact/tolerance=1", {"contact/tolerance", "allowed"});
  expect_refusal("run --set box.xml", {"--set: found 'box.xml'", "PATH=VALUE"});
  expect_refusal("run box.xml --set time/@end=0.02 more.xml", {"does not expect 'more.xml'", "nilas run --help"});
}

TEST_F(Usage, AFaultNamesTheFlagThatMadeIt) {
  expect_refusal("run box.xml --until 0", {"--until: <time end>: found 0; allowed: after the start"});
  expect_refusal("run box.xml --set time/@end=0", {"--set: <time end>: found 0"});
  expect_refusal("run box.xml --solver nothing --dt 0", {"--solver: <contact solver>", "--dt: <time step>"});
  expect_refusal("view run --png abc", {"--png: found 'abc'; allowed: a number"});
  expect_refusal("run box.xml --seed 1.5", {"--seed: found '1.5'; allowed: a whole number"});
}

TEST_F(Usage, AFileInThePlaceOfAFolderIsNamed) {
  expect_refusal("view box.xml", {"box.xml: is a file; allowed: the folder of a run"});
  expect_refusal("report box.xml", {"box.xml: is a file; a report needs the folder of a run"});
  ASSERT_EQ(nilas("run box.xml --quiet --out run").exit_code, 0);
  const auto folder_run = nilas("run run");
  EXPECT_EQ(folder_run.exit_code, 4);
  EXPECT_TRUE(mentions(folder_run.err, "run: is a folder; allowed: the XML file of a scene")) << folder_run.err;
  EXPECT_TRUE(mentions(folder_run.err, "run/scene.xml is its scene")) << folder_run.err;
}

TEST_F(Usage, AnUnknownCommandIsAnsweredWithTheNearest) {
  expect_refusal("rnu box.xml", {"'rnu' is no command", "the nearest is run", "nilas --help"});
  expect_refusal("chekc box.xml", {"the nearest is check"});
  expect_refusal("simulate box.xml", {"'simulate' is no command", "run, check, hull"});
}

TEST_F(Usage, AnUnknownFlagIsAnsweredWithTheNearest) {
  expect_refusal("run box.xml --untill 3", {"nilas run has no flag --untill", "the nearest is --until", "--help"});
  expect_refusal("run box.xml --theads=2", {"has no flag --theads;", "the nearest is --threads"});
  expect_refusal("run box.xml -quiet", {"has no flag -quiet;", "the nearest is --quiet"});
  expect_refusal("hull --generate wedge --draft 0.2", {"the nearest is --draught"});
  // the flag that is missing is the one that was misspelt
  expect_refusal("report run --contcts 5", {"has no flag --contcts;", "the nearest is --contacts"});
  expect_refusal("run box.xml --zzzzzzzzz", {"has no flag --zzzzzzzzz.", "`nilas run --help` lists all."});
}

TEST_F(Usage, WithoutAnyWordTheHelpIsShown) {
  const auto bare = nilas("");
  EXPECT_EQ(bare.exit_code, 2);
  EXPECT_EQ(bare.out, "");
  EXPECT_EQ(bare.err, nilas("--help").out);
}

}  // namespace usage_test
